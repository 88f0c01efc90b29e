// The report of a diagnosis: verdict, where the gap lies, which effect causes it, how far it goes,
// what this test can tell apart, what to measure next.
#pragma once

#include "diagnose/results/diagnosis.hpp"

#include <string>

namespace plica {

std::string diagnosis_html(const Diagnosis& d, const std::string& title);

} // namespace plica

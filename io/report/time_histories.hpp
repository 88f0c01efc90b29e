// Transients and run-ups of the report.
#pragma once

#include "run/results/results.hpp"

#include <string>

namespace plica {

std::string transients_html(const Results& results); // over time, with shock spectra
std::string run_ups_html(const Results& results);    // Campbell picture, orders, overall level

} // namespace plica

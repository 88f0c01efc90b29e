// Section of the report on superelements, and the report of a reduction with its certificate.
#pragma once

#include "run/results/results.hpp"
#include "run/study/reduce.hpp"

#include <string>

namespace plica {

// Empty when nothing was reduced.
std::string superelements_html(const Results& results);

// A whole page.
std::string certificate_report(const ReducedCase& reduced);

} // namespace plica

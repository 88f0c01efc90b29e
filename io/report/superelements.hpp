// Section of the report on superelements, and the report of a reduction with its certificate.
#pragma once

#include "run/results/results.hpp"
#include "run/study/reduce.hpp"

#include <string>

namespace plica {

// Empty when nothing was reduced.
std::string superelements_html(const Results& results);

// A whole page, of an element in SI. `units`: of the files that it stands beside.
std::string certificate_report(const ReducedCase& reduced, const std::string& units);

} // namespace plica

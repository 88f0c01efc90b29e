// The report of a comparison of simulation and test.
#pragma once

#include "compare/correlate.hpp"

#include <string>

namespace plica {

std::string correlation_html(const Correlation& c, const TestData& simulated,
                             const TestData& measured);

} // namespace plica

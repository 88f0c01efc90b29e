// A correlation in words.
#pragma once

#include "compare/correlate.hpp"

namespace plica {

// "axial 1 in y", or "mode 3" of a list.
std::string mode_name(const MeasuredMode& mode, int index);

// For the terminal.
std::string correlation_text(const Correlation& c, const TestData& simulated,
                             const TestData& measured);

} // namespace plica

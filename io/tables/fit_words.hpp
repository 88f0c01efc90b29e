// A fit in words.
#pragma once

#include "compare/fit/fit.hpp"

namespace plica {

// "at most 0.065", "1.2 to 1.4"
std::string constraint_limits(const FittedConstraint& constraint);

// "a joint change of a (0.71) and b (-0.70): 0.3 sigma over the whole range of the bounds"
std::string open_text(const OpenDirection& open);

// For the terminal.
std::string fit_text(const FitResult& fit);

} // namespace plica

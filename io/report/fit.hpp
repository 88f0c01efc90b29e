// Report of a fit: parameters with uncertainty and correlation, targets, what is left open, the
// designs that were tried.
#pragma once

#include "compare/fit/fit.hpp"

#include <string>

namespace plica {

std::string fit_html(const FitResult& fit, const std::string& title);

} // namespace plica

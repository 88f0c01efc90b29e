// Response to base motion in the report: a plot per direction and its peaks.
#pragma once

#include "run/results/results.hpp"

namespace plica {

// Empty when the run has no response.
std::string responses_html(const Results& results);

} // namespace plica

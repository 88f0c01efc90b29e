// Stress and life in the report, each empty when nothing was asked.
#pragma once

#include "run/results/results.hpp"

#include <string>

namespace plica {

std::string stresses_html(const Results& results); // largest ones, by place, along the meridian
std::string life_html(const Results& results);     // duties, hot spots, picture, densities

} // namespace plica

// Bodies, springs and what is held, in a drawing (scene.hpp).
#pragma once

#include "io/report/scene.hpp"
#include "run/results/results.hpp"

namespace plica {

// <g> of all symbols with their names; `size`: of the part, m.
std::string symbol_marks(const Results& results, const View& view, const Frame& frame, double size);

// Radius of the ball that stands for a body, m: of 1500 kg/m3, and neither a point nor in the way.
double ball_radius(double mass, double size);

} // namespace plica

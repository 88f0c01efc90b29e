// Connectors with a tabulated force: straight lines between [displacement, force] points and beyond
// the last ones.
#pragma once

#include "model/description/case.hpp"

namespace plica {

using ForceCurve = std::vector<std::array<double, 2>>; // increasing, through [0, 0]

// Slope over the points on both sides of rest: what a linear analysis takes. Throws
// std::invalid_argument for a curve that does not increase.
double stiffness_at_rest(const ForceCurve& curve);

double displacement_at(const ForceCurve& curve, double force);
double force_at(const ForceCurve& curve, double displacement);

// Force over displacement between the caps where the stiffness is tabulated: straight lines.
struct StrokeCurve {
  static constexpr const char *along = "axial", *across = "transverse";
  std::string direction;                     // one of these
  std::vector<std::array<double, 2>> points; // m, N, increasing
};

// Of a chain with such springs, one end held, the other moved along, or across and kept parallel.
// Every element bears the same force, so their displacements add; across, the bending of the
// elements adds sum (s - s0)^2 / b per force, s their places and s0 their mean weighted by 1/b.
// Empty for a chain without curves.
std::vector<StrokeCurve> stroke_curves(const ConnectorChain& chain);

} // namespace plica

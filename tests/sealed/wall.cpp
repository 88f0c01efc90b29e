#include "wall.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sealed {

double stiffness_factor(const WallShape& shape, const WallSpecimen& s, double y, double angle) {
  const double at = std::clamp((y - shape.crown(1)) / shape.pitch, 0., shape.convolutions - 1.);
  const int k = std::min(int(at), shape.convolutions - 2);
  const double field = s.E[k] + (at - k) * (s.E[k + 1] - s.E[k]);
  const bool in_dent = s.dent > 0 && std::abs(y - shape.crown(s.dent)) < shape.pitch / 2 &&
                       std::cos(angle - s.dent_angle) > std::cos(std::numbers::pi / 4);
  return field * (in_dent ? 1 - s.dent_loss : 1);
}

double thickness_at(const WallShape& shape, const WallSpecimen& s, double radius) {
  return shape.thickness * s.thickness * std::pow(shape.root_radius / radius, s.thinning);
}

double bending_factor(double bond) {
  return 0.25 + 0.75 * bond;
}

} // namespace sealed

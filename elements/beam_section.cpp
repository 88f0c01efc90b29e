#include "elements/beam_section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using std::numbers::pi;

BeamProperties properties(const BeamMaterial& m, double A, double I_y, double I_z, double J,
                          double shear_coefficient,
                          const std::vector<std::array<double, 2>>& fibres) {
  const double G = m.E / (2 * (1 + m.nu));
  return {.EA = m.E * A,
          .EI_y = m.E * I_y,
          .EI_z = m.E * I_z,
          .GJ = G * J,
          .GA_y = shear_coefficient * G * A,
          .GA_z = shear_coefficient * G * A,
          .mass = m.rho * A,
          .inertia_x = m.rho * (I_y + I_z),
          .inertia_y = m.rho * I_y,
          .inertia_z = m.rho * I_z,
          .fibres = fibres,
          .E = m.E};
}

std::vector<std::array<double, 2>> circle(double radius) {
  std::vector<std::array<double, 2>> points;
  points.reserve(24);
  for (int k = 0; k < 24; ++k)
    points.push_back({radius * std::cos(k * pi / 12), radius * std::sin(k * pi / 12)});
  return points;
}

// Saint-Venant torsion constant of an a x b rectangle (Timoshenko & Goodier, art. 109).
double rectangle_torsion(double width, double depth) {
  const double a = std::min(width, depth), b = std::max(width, depth);
  double sum = 0;
  for (int n = 1; n < 40; n += 2) sum += std::tanh(n * pi * b / (2 * a)) / std::pow(n, 5);
  return a * a * a * b / 3 * (1 - 192 * a / (std::pow(pi, 5) * b) * sum);
}

} // namespace

BeamProperties pipe_section(const BeamMaterial& m, double radius, double wall) {
  const double outer = radius + wall / 2, inner = radius - wall / 2;
  const double I = pi / 4 * (std::pow(outer, 4) - std::pow(inner, 4));
  return properties(m, 2 * pi * radius * wall, I, I, 2 * I, 2 * (1 + m.nu) / (4 + 3 * m.nu),
                    circle(outer));
}

BeamProperties round_section(const BeamMaterial& m, double radius) {
  const double I = pi / 4 * std::pow(radius, 4);
  return properties(m, pi * radius * radius, I, I, 2 * I, 6 * (1 + m.nu) / (7 + 6 * m.nu),
                    circle(radius));
}

BeamProperties rectangle_section(const BeamMaterial& m, double width, double depth) {
  const double y = width / 2, z = depth / 2;
  return properties(m, width * depth, width * std::pow(depth, 3) / 12,
                    depth * std::pow(width, 3) / 12, rectangle_torsion(width, depth),
                    10 * (1 + m.nu) / (12 + 11 * m.nu), {{y, z}, {-y, z}, {-y, -z}, {y, -z}});
}

} // namespace plica

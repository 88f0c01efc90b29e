#include "io/decks/deck_sections.hpp"

#include <algorithm>
#include <cmath>

namespace plica {

BeamProperties general_section(const BeamMaterial& m, double A, double I_y, double I_z, double J) {
  return {.EA = m.E * A,
          .EI_y = m.E * I_y,
          .EI_z = m.E * I_z,
          .GJ = m.E / (2 * (1 + m.nu)) * J,
          .mass = m.rho * A,
          .inertia_x = m.rho * (I_y + I_z),
          .inertia_y = m.rho * I_y,
          .inertia_z = m.rho * I_z,
          .E = m.E};
}

// With axes turned by a from y to z: I_y' = mean + half cos 2a - I_yz sin 2a is the larger.
TurnedSection principal_section(const BeamMaterial& m, double A, double I_y, double I_z,
                                double I_yz, double J) {
  const double mean = (I_y + I_z) / 2, half = (I_y - I_z) / 2;
  if (!(std::abs(I_yz) > 1e-12 * mean)) return {general_section(m, A, I_y, I_z, J), 0};
  const double largest = std::hypot(half, I_yz);
  return {general_section(m, A, mean + largest, mean - largest, J), std::atan2(-I_yz, half) / 2};
}

TurnedSection rectangles_section(const BeamMaterial& m, const std::vector<ProfileRectangle>& all,
                                 double J) {
  double A = 0, y = 0, z = 0;
  for (const ProfileRectangle& r : all) {
    A += r.width * r.depth;
    y += r.width * r.depth * r.y;
    z += r.width * r.depth * r.z;
  }
  y /= A;
  z /= A;
  double I_y = 0, I_z = 0, I_yz = 0, open = 0;
  for (const ProfileRectangle& r : all) {
    const double a = r.width * r.depth, t = std::min(r.width, r.depth);
    I_y += a * (r.depth * r.depth / 12 + (r.z - z) * (r.z - z));
    I_z += a * (r.width * r.width / 12 + (r.y - y) * (r.y - y));
    I_yz += a * (r.y - y) * (r.z - z);
    open += a * t * t / 3;
  }
  TurnedSection section = principal_section(m, A, I_y, I_z, I_yz, J > 0 ? J : open);
  section.centroid = {y, z};
  const double c = std::cos(section.turn), s = std::sin(section.turn);
  for (const ProfileRectangle& r : all)
    for (double sign_y : {-0.5, 0.5})
      for (double sign_z : {-0.5, 0.5}) {
        const double u = r.y - y + sign_y * r.width, v = r.z - z + sign_z * r.depth;
        section.properties.fibres.push_back({c * u + s * v, c * v - s * u});
      }
  return section;
}

} // namespace plica

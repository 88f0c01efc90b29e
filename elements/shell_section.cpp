#include "elements/shell_section.hpp"

#include <cmath>

namespace plica {

ShellLaw shell_law(const ShellSection& section) {
  const double E = section.E, nu = section.nu;
  Eigen::Matrix3d C;
  C << 1, nu, 0, nu, 1, 0, 0, 0, (1 - nu) / 2;
  const double shear_modulus = E / (2 * (1 + nu));
  return {.in_plane = E / (1 - nu * nu) * C,
          .shear = section.shear_correction * shear_modulus * Eigen::Matrix2d::Identity(),
          .drilling = section.drilling * shear_modulus};
}

double ply_bending_factor(const std::vector<double>& plies, double bond) {
  double total = 0, slipped = 0;
  for (double t : plies) {
    total += t;
    slipped += t * t * t;
  }
  slipped /= total * total * total;
  return slipped + bond * (1 - slipped);
}

} // namespace plica

// A cantilever of one beam element: its tip under a force, and what it weighs.
#include "expect.hpp"
#include "plica/elements/beam_timoshenko.hpp"
#include "plica/elements/rigid_mass.hpp"

#include <Eigen/LU>

int main() {
  using namespace plica;
  constexpr double E = 200e9, nu = 0.25, rho = 8000, L = 0.5, width = 0.02, depth = 0.1;
  const BeamGeometry beam{.node1 = {0, 0, 0}, .node2 = {0, L, 0}};
  const BeamProperties section = rectangle_section({.E = E, .nu = nu, .rho = rho}, width, depth);
  const Matrix12 K = beam_stiffness(beam, section), M = beam_mass(beam, section);

  // Bending and shear of a deep beam, k of Cowper: P L^3 / (3 E I) + P L / (k G A).
  constexpr double A = width * depth, I = A * depth * depth / 12, G = E / 2 / (1 + nu), P = 1000;
  constexpr double k = 10 * (1 + nu) / (12 + 11 * nu);
  const Matrix6 held = K.bottomRightCorner<6, 6>();
  const Eigen::Vector<double, 6> tip = held.lu().solve(P * Eigen::Vector<double, 6>::Unit(2));
  expect_near(tip[2], P * L * L * L / (3 * E * I) + P * L / (k * G * A), "deflection of the tip");

  const Eigen::Vector<double, 12> along = Eigen::Vector<double, 6>::Unit(1).replicate<2, 1>();
  expect_near(along.dot(M * along), rho * A * L, "mass");
  return differs;
}

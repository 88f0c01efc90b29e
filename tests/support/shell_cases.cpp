#include "tests/support/shell_cases.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace plica::test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

ShellGeometry quad(std::initializer_list<Vector3d> corners, double thickness) {
  ShellGeometry g;
  int i = 0;
  for (const Vector3d& x : corners) g.X.col(i++) = x;
  for (i = 0; i < 4; ++i)
    g.directors.col(i) = Vector3d(g.X.col((i + 1) % 4) - g.X.col(i))
                             .cross(Vector3d(g.X.col((i + 3) % 4) - g.X.col(i)))
                             .normalized();
  g.thickness.setConstant(thickness);
  return g;
}

} // namespace

ShellGeometry flat_shell() {
  return quad({{0, 0, 0}, {1.2, 0, 0}, {1.2, 0.8, 0}, {0, 0.8, 0}}, 0.1);
}
namespace {

ShellGeometry parallelogram() {
  return quad({{0, 0, 0}, {1.2, 0, 0}, {1.7, 0.8, 0}, {0.5, 0.8, 0}}, 0.1);
}
ShellGeometry skewed() {
  return quad({{0, 0, 0}, {1.2, 0.1, 0}, {1.5, 0.9, 0}, {-0.1, 0.6, 0}}, 0.1);
}
ShellGeometry turned() {
  ShellGeometry g = skewed();
  const Matrix3d R = Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  g.X = R * g.X;
  g.directors = R * g.directors;
  return g;
}
ShellGeometry warped() {
  return quad({{0, 0, 0.1}, {1.2, 0.1, -0.1}, {1.5, 0.9, 0.2}, {-0.1, 0.6, -0.15}}, 0.1);
}
// A piece of a cylinder of radius 0.3: directors well off the normal of the flat corners.
ShellGeometry curved() {
  ShellGeometry g;
  for (int i = 0; i < 4; ++i) {
    const double angle = i == 1 || i == 2 ? 0.3 : -0.2;
    g.directors.col(i) << std::sin(angle), 0, std::cos(angle);
    g.X.col(i) << 0.3 * std::sin(angle), i < 2 ? 0 : 0.2 + 0.1 * angle, 0.3 * std::cos(angle);
  }
  g.thickness << 0.1, 0.08, 0.09, 0.1;
  return g;
}
// Warped corners with directors of a doubly curved surface.
ShellGeometry curved_warped() {
  ShellGeometry g = warped();
  for (int i = 0; i < 4; ++i)
    g.directors.col(i) = Vector3d(0.4 * g.X(0, i) - 0.2, -0.3 * g.X(1, i) + 0.1, 1).normalized();
  return g;
}

} // namespace

std::vector<ShellCase> flat_shells() {
  return {{"flat", flat_shell()},
          {"parallelogram", parallelogram()},
          {"skewed", skewed()},
          {"turned", turned()}};
}

std::vector<ShellCase> all_shells() {
  std::vector<ShellCase> cases = flat_shells();
  cases.push_back({"warped", warped()});
  cases.push_back({"curved", curved()});
  cases.push_back({"curved_warped", curved_warped()});
  return cases;
}

std::vector<Vector3d> corners(const ShellGeometry& g) {
  return {g.X.col(0), g.X.col(1), g.X.col(2), g.X.col(3)};
}

VectorXd random_vector(int size, unsigned seed) {
  std::mt19937 random(seed);
  VectorXd v(size);
  for (double& x : v) x = 2 * double(random()) / double(std::mt19937::max()) - 1;
  return v;
}

} // namespace plica::test

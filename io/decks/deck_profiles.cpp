#include "io/decks/deck_profiles.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::Vector2d;

struct Quarter { // of a hexagon, its height over half of it, v = 0 to 1
  double tip = 0, width = 0, height = 0;
  double half_width(double v) const { return width / 2 - tip * v; }
};

// Value and slopes along y and z of u^2i v^j (1 - u^2) (1 - v^2), u the share of the half width.
struct Trial {
  double value = 0, along_y = 0, along_z = 0;
};

Trial trial(const Quarter& q, int i, int j, double u, double v) {
  const auto term = [](int power, double x) { // x^power (1 - x^2) and its slope
    const double at = std::pow(x, power) * (1 - x * x);
    const double slope =
        (power > 0 ? power * std::pow(x, power - 1) : 0) - (power + 2) * std::pow(x, power + 1);
    return Vector2d(at, slope);
  };
  const Vector2d a = term(2 * i, u), b = term(j, v);
  const double w = q.half_width(v);
  const double by_u = a[1] * b[0], by_v = a[0] * b[1];
  return {a[0] * b[0], by_u / w, (by_v + u * q.tip / w * by_u) * 2 / q.height};
}

// Prandtl's stress function: J = 2 int phi, with the least of int |grad phi|^2 / 2 - 2 phi.
double hexagon_torsion(const Quarter& q) {
  constexpr int even = 4, up = 6, count = even * up, points = 10;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd F = Eigen::VectorXd::Zero(count);
  // Gauss-Legendre by the eigenvalues of its recurrence (Golub and Welsch 1969).
  Eigen::MatrixXd recurrence = Eigen::MatrixXd::Zero(points, points);
  for (int k = 1; k < points; ++k)
    recurrence(k, k - 1) = recurrence(k - 1, k) = k / std::sqrt(4. * k * k - 1);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gauss(recurrence);
  for (Index a = 0; a < points; ++a)
    for (Index b = 0; b < points; ++b) {
      const double u = (1 + gauss.eigenvalues()[a]) / 2, v = (1 + gauss.eigenvalues()[b]) / 2;
      const double area = std::pow(gauss.eigenvectors()(0, a) * gauss.eigenvectors()(0, b), 2) *
                          q.half_width(v) * q.height / 2;
      Eigen::VectorXd value(count), y(count), z(count);
      for (int i = 0; i < even; ++i)
        for (int j = 0; j < up; ++j) {
          const Trial t = trial(q, i, j, u, v);
          value[i * up + j] = t.value;
          y[i * up + j] = t.along_y;
          z[i * up + j] = t.along_z;
        }
      K += area * (y * y.transpose() + z * z.transpose());
      F += 2 * area * value;
    }
  return 4 * F.dot(K.ldlt().solve(F));
}

void add_wall(Profile& p, double y1, double z1, double y2, double z2, double thickness) {
  p.walls.push_back({{y1, z1}, {y2, z2}, thickness});
}

} // namespace

TurnedSection profile_section(const BeamMaterial& m, const Profile& profile) {
  for (const ProfileRectangle& r : profile.rectangles)
    if (!(r.width > 0 && r.depth > 0)) throw std::invalid_argument("walls that do not fit");
  const ThinWallSection thin = thin_wall_section(profile.walls);
  TurnedSection section = rectangles_section(m, profile.rectangles, thin.closed ? thin.J : 0);
  section.shear_centre = {thin.shear_centre[0], thin.shear_centre[1]};
  const double G = m.E / (2 * (1 + m.nu));
  const Vector2d y(std::cos(section.turn), std::sin(section.turn)), z(-y[1], y[0]);
  section.properties.GA_y = G / y.dot(thin.shear_compliance * y);
  section.properties.GA_z = G / z.dot(thin.shear_compliance * z);
  return section;
}

Profile i_profile(double height, double web, const Flange& lower, const Flange& upper) {
  Profile p;
  const double low = lower.width > 0 ? lower.thickness : 0;
  const double high = upper.width > 0 ? upper.thickness : 0;
  for (const bool above : {false, true}) {
    const Flange& f = above ? upper : lower;
    if (!(f.width > 0)) continue;
    const double z = above ? height - f.thickness / 2 : f.thickness / 2;
    p.rectangles.push_back({0, z, f.width, f.thickness});
    add_wall(p, -f.width / 2, z, 0, z, f.thickness);
    add_wall(p, 0, z, f.width / 2, z, f.thickness);
  }
  p.rectangles.push_back({0, (low + height - high) / 2, web, height - low - high});
  add_wall(p, 0, low / 2, 0, height - high / 2, web);
  return p;
}

Profile l_profile(double width, double height, double foot, double leg) {
  Profile p;
  if (!(width > leg)) throw std::invalid_argument("a leg as wide as the whole");
  p.rectangles = {{width / 2, foot / 2, width, foot},
                  {leg / 2, (foot + height) / 2, leg, height - foot}};
  add_wall(p, leg / 2, foot / 2, width, foot / 2, foot);
  add_wall(p, leg / 2, foot / 2, leg / 2, height, leg);
  return p;
}

Profile box_profile(double width, double height, const BoxWalls& w) {
  Profile p;
  const double inside = width - w.left - w.right, middle = (w.left - w.right) / 2;
  if (!(height > w.top + w.bottom)) throw std::invalid_argument("walls that leave no hole");
  p.rectangles = {{(w.left - width) / 2, 0, w.left, height},
                  {(width - w.right) / 2, 0, w.right, height},
                  {middle, (w.bottom - height) / 2, inside, w.bottom},
                  {middle, (height - w.top) / 2, inside, w.top}};
  const double left = (w.left - width) / 2, right = (width - w.right) / 2;
  const double bottom = (w.bottom - height) / 2, top = (height - w.top) / 2;
  add_wall(p, left, bottom, right, bottom, w.bottom);
  add_wall(p, right, bottom, right, top, w.right);
  add_wall(p, right, top, left, top, w.top);
  add_wall(p, left, top, left, bottom, w.left);
  return p;
}

TurnedSection hexagon_section(const BeamMaterial& m, double tip, double width, double height) {
  const double side = width - 2 * tip, A = height * (width - tip), h3 = height * height * height;
  if (!(tip > 0 && side > 0 && height > 0)) throw std::invalid_argument("tips that meet");
  TurnedSection section;
  section.properties = general_section(m, A, width * h3 / 12 - tip * h3 / 8,
                                       height * (width * width + side * side) * (width + side) / 48,
                                       hexagon_torsion({tip, width, height}));
  section.properties.GA_y = section.properties.GA_z =
      10 * (1 + m.nu) / (12 + 11 * m.nu) * m.E / (2 * (1 + m.nu)) * A;
  for (const double up : {-0.5, 0.0, 0.5})
    for (const double right : {-0.5, 0.5})
      section.properties.fibres.push_back({right * (up == 0 ? width : side), up * height});
  return section;
}

} // namespace plica

#include "tests/support/meridian_torsion.hpp"

#include <cmath>
#include <numbers>

namespace plica::test {
namespace {

// int r^-3 ds over a straight line: exact.
double line_integral(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return (b - a).norm() * (a.y() + b.y()) / (2 * std::pow(a.y() * b.y(), 2));
}

// Over an arc by Simpson's rule, its error far below rounding of any use.
double arc_integral(const MeridianCurve& arc) {
  const Eigen::Vector2d a = arc.start - arc.centre, b = arc.end - arc.centre;
  const double turn = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  const double first = std::atan2(a.y(), a.x()), radius = a.norm();
  constexpr int panels = 200;
  double sum = 0;
  for (int i = 0; i <= panels; ++i) {
    const double weight = i == 0 || i == panels ? 1 : i % 2 == 1 ? 4 : 2;
    const double r = arc.centre.y() + radius * std::sin(first + turn * i / panels);
    sum += weight / (r * r * r);
  }
  return sum * radius * std::abs(turn) / (3 * panels);
}

double spline_integral(MeridianCurve spline) {
  spline.elements = 2000;
  const CurveNodes nodes = mesh_curves({spline}).front();
  double sum = 0;
  for (std::size_t i = 1; i < nodes.positions.size(); ++i)
    sum += line_integral(nodes.positions[i - 1], nodes.positions[i]);
  return sum;
}

} // namespace

double torsion_stiffness(const Meridian& meridian, double G, double wall) {
  double integral = 0;
  for (const MeridianCurve& curve : meridian.curves())
    integral += curve.kind == CurveKind::line  ? line_integral(curve.start, curve.end)
                : curve.kind == CurveKind::arc ? arc_integral(curve)
                                               : spline_integral(curve);
  return 2 * std::numbers::pi * G * wall / integral;
}

} // namespace plica::test

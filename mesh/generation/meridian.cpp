#include "mesh/generation/meridian.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plica {

using Eigen::Vector2d;

Meridian::Meridian(double y, double radius) : tip_(y, radius) {}

MeridianCurve& Meridian::line_to(const Vector2d& end, int elements) {
  MeridianCurve curve;
  curve.start = tip_;
  curve.end = end;
  curve.elements = elements;
  tip_ = end;
  return curves_.emplace_back(curve);
}

MeridianCurve& Meridian::arc_to(const Vector2d& end, const Vector2d& centre, int elements) {
  MeridianCurve& curve = line_to(end, elements);
  curve.kind = CurveKind::arc;
  curve.centre = centre;
  return curve;
}

void Meridian::add_cuff(double length, double end_radius, int elements) {
  line_to({tip_.x() + length, end_radius}, elements);
}

HalfConvolution half_convolution(const Convolution& c) {
  const double a = c.root_arc + c.crown_arc, half_pitch = c.pitch / 2, rise = c.height - a;
  const double wall2 = half_pitch * half_pitch + rise * rise - a * a;
  if (wall2 < -1e-12 * a * a)
    throw std::invalid_argument("the arcs of a convolution do not fit its height and pitch");
  const double wall = std::sqrt(std::max(0., wall2));
  return {std::atan2(a, wall) + std::atan2(rise, half_pitch), wall};
}

void Meridian::add_convolution(const Convolution& c, const MeridianDensity& density) {
  const auto [phi, wall] = half_convolution(c);
  const Vector2d root = tip_;
  const Vector2d crown = root + Vector2d(c.pitch / 2, c.height);
  const Vector2d next = root + Vector2d(c.pitch, 0);
  const Vector2d root_left = root + Vector2d(0, c.root_arc);
  const Vector2d root_right = next + Vector2d(0, c.root_arc);
  const Vector2d crown_centre = crown - Vector2d(0, c.crown_arc);
  const Vector2d outward(std::sin(phi), -std::cos(phi)); // from the root centre to the wall, left
  const Vector2d mirrored(-outward.x(), outward.y());
  const int arc =
      std::max(1, static_cast<int>(std::ceil(density.arc * phi / (std::numbers::pi / 2) - 1e-9)));
  const bool has_wall = wall > 1e-9 * c.pitch;

  const std::size_t first = curves_.size();
  arc_to(root_left + c.root_arc * outward, root_left, arc);
  if (has_wall) line_to(crown_centre - c.crown_arc * outward, density.wall);
  arc_to(crown, crown_centre, arc).ends_at_crown = true;
  arc_to(crown_centre - c.crown_arc * mirrored, crown_centre, arc);
  if (has_wall) line_to(root_right + c.root_arc * mirrored, density.wall);
  arc_to(next, root_right, arc);
  ++convolutions_;
  curves_[first].starts_at_root = true;
  for (std::size_t i = first; i < curves_.size(); ++i) curves_[i].convolution = convolutions_;
}

void Meridian::add_disc(double height, double pitch, const MeridianDensity& density) {
  const Vector2d root = tip_;
  ++convolutions_;
  MeridianCurve& up = line_to(root + Vector2d(pitch / 2, height), density.wall);
  up.starts_at_root = up.ends_at_crown = true;
  up.convolution = convolutions_;
  line_to(root + Vector2d(pitch, 0), density.wall).convolution = convolutions_;
}

void Meridian::add_points(const std::vector<Vector2d>& points, bool smooth,
                          const MeridianDensity& density) {
  if (points.size() < 3) throw std::invalid_argument("a profile needs at least three points");
  const Vector2d origin(tip_.x() - points.front().x(), 0);
  const auto crown = std::max_element(points.begin(), points.end(),
                                      [](auto& a, auto& b) { return a.y() < b.y(); });
  ++convolutions_;
  const std::size_t first = curves_.size();
  if (smooth) {
    MeridianCurve& curve = line_to(origin + points.back(), 4 * density.arc + 2 * density.wall);
    curve.kind = CurveKind::spline;
    for (const Vector2d& p : points) curve.points.push_back(origin + p);
  } else {
    for (std::size_t i = 1; i < points.size(); ++i)
      line_to(origin + points[i], density.wall).ends_at_crown = &points[i] == &*crown;
  }
  curves_[first].starts_at_root = true;
  for (std::size_t i = first; i < curves_.size(); ++i) curves_[i].convolution = convolutions_;
}

namespace {

Vector2d left_normal(const Vector2d& tangent) {
  return Vector2d(-tangent.y(), tangent.x()).normalized();
}

// Puts the nodes of a curve exactly where its equation has them, with the exact normal.
std::vector<MeridianPoint> exact_points(const MeridianCurve& curve, const CurveNodes& nodes) {
  std::vector<MeridianPoint> points;
  const Vector2d chord = curve.end - curve.start;
  const double radius = (curve.start - curve.centre).norm();
  const Vector2d from_centre = curve.start - curve.centre;
  const double turn = chord.x() * from_centre.y() - chord.y() * from_centre.x() > 0 ? 1 : -1;
  for (std::size_t i = 0; i < nodes.positions.size(); ++i) {
    Vector2d p = nodes.positions[i], normal = left_normal(chord);
    if (curve.kind == CurveKind::arc) {
      const Vector2d out = (p - curve.centre).normalized();
      p = curve.centre + radius * out;
      normal = turn * out; // clockwise about a crown centre: outward; about a root centre: inward
    } else if (curve.kind == CurveKind::spline) {
      normal = left_normal(nodes.tangents[i]);
    }
    points.push_back({p, normal});
  }
  points.front().position = curve.start;
  points.back().position = curve.end;
  return points;
}

} // namespace

std::vector<std::vector<MeridianPoint>> mesh_meridian(const Meridian& meridian) {
  const std::vector<CurveNodes> nodes = mesh_curves(meridian.curves());
  std::vector<std::vector<MeridianPoint>> points;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    points.push_back(exact_points(meridian.curves()[i], nodes[i]));
  return points;
}

} // namespace plica

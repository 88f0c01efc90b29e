#include "model/description/profile.hpp"

#include "mesh/generation/meridian.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace plica {

namespace {

using Point = std::array<double, 2>;
constexpr double slack = 1e-9; // relative

std::string mm(double length) {
  char buffer[32];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, length * 1000, std::chars_format::general, 6);
  return std::string(buffer, end.ptr) + " mm";
}

double side(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto apart = [](double p, double q, double r, double s) {
    return std::max(p, q) < std::min(r, s) || std::max(r, s) < std::min(p, q);
  };
  if (apart(a[0], b[0], c[0], d[0]) || apart(a[1], b[1], c[1], d[1])) return false;
  return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
}

// First pair of segments of two neighbouring convolutions that cross, as indices of their first
// points; {-1, -1} = none. Segments that share a point are not compared.
std::array<int, 2> first_crossing(const std::vector<Point>& points) {
  std::vector<Point> chain = points;
  const double pitch = points.back()[0];
  for (std::size_t i = 1; i < points.size(); ++i)
    chain.push_back({points[i][0] + pitch, points[i][1]});
  const int n = static_cast<int>(chain.size());
  for (int i = 0; i < static_cast<int>(points.size()) - 1; ++i)
    for (int j = i + 2; j + 1 < n; ++j)
      if (cross(chain[i], chain[i + 1], chain[j], chain[j + 1])) return {i, j};
  return {-1, -1};
}

void check_points(const MeridianSection& s, double radius, std::vector<ProfileProblem>& problems) {
  const std::vector<Point>& p = s.points;
  const auto item = [](std::size_t i) { return "points[" + std::to_string(i) + "]"; };
  const std::size_t last = p.size() - 1;
  const double tolerance = 1e-6 * radius;
  bool ordered = true;
  const auto add = [&](std::size_t i, std::string wrong, std::string allowed) {
    problems.push_back({item(i), std::move(wrong), std::move(allowed)});
    ordered = false;
  };
  if (p[0][0] != 0) add(0, "the first point is at y = " + mm(p[0][0]), "it must be at y = 0");
  if (p[last][0] <= 0)
    add(last, "the last point is at y = " + mm(p[last][0]), "it must be right of the first one");
  if (std::abs(p[0][1] - radius) > tolerance)
    add(0, "starts at radius " + mm(p[0][1]), "the meridian has come to radius " + mm(radius));
  if (std::abs(p[last][1] - p[0][1]) > tolerance)
    add(last, "ends at radius " + mm(p[last][1]),
        "a convolution ends at the radius where it starts, " + mm(p[0][1]));
  for (std::size_t i = 0; i <= last; ++i)
    if (p[i][1] <= 0) add(i, "the radius is " + mm(p[i][1]), "it must be above 0");
  for (std::size_t i = 1; i <= last; ++i)
    if (p[i] == p[i - 1]) add(i, "repeats the point before it", "points must differ");
  if (!ordered) return;
  const auto [i, j] = first_crossing(p);
  if (i < 0) return;
  const int n = static_cast<int>(last);
  problems.push_back({"points",
                      "the profile crosses itself: points " + std::to_string(i) + "-" +
                          std::to_string(i + 1) + " and " + std::to_string(j % n) + "-" +
                          std::to_string(j % n + 1) + (j >= n ? " of the next convolution" : ""),
                      "points in order along the wall, and neighbours that do not touch"});
}

// Arc angle of half a convolution; empty when the arcs do not fit.
std::optional<double> arc_angle(const Convolution& shape) try {
  return half_convolution(shape).angle;
} catch (const std::invalid_argument&) {
  return std::nullopt;
}

void check_arcs(const MeridianSection& s, double t, std::vector<ProfileProblem>& problems) {
  const double q = s.pitch, h = s.height;
  const double Rr = root_arc_radius(s), Rc = crown_arc_radius(s), a = Rr + Rc;
  const auto add = [&](std::string key, std::string wrong, std::string allowed) {
    problems.push_back({std::move(key), std::move(wrong), std::move(allowed)});
  };
  const bool omega = s.shape == SectionShape::omega;
  if (omega && a <= q / 2 * (1 + slack))
    return add("",
               "an omega with root and crown arc radii of together " + mm(a) +
                   " has walls that do not lean over",
               "root_arc_radius + crown_arc_radius must be above pitch/2 = " + mm(q / 2) +
                   ", or use shape U");
  const std::optional<double> phi =
      arc_angle({.height = h, .pitch = q, .root_arc = Rr, .crown_arc = Rc});
  const double rise = std::sqrt(std::max(0.0, a * a - q * q / 4));
  if (!phi)
    return add("height", "the arcs do not fit the height of " + mm(h),
               omega ? "height must be at least " + mm(a + rise) + " with these arc radii"
                     : "root_arc_radius + crown_arc_radius must be at most pitch/2 = " + mm(q / 2) +
                           ", or height at most " + mm(a - rise));
  const bool leans = *phi > std::numbers::pi / 2 + 1e-9;
  if (leans && !omega)
    return add("", "the walls of a U with arc radii of together " + mm(a) + " lean over",
               "root_arc_radius + crown_arc_radius must be at most pitch/2 = " + mm(q / 2) +
                   ", or use shape omega");
  if (!leans && omega)
    return add("height", "an omega of height " + mm(h) + " has walls that do not lean over",
               "height must be at least " + mm(a + rise) + ", or use shape U");
  if (t >= 2 * std::min(Rr, Rc) * (1 - slack))
    add("", "the wall of " + mm(t) + " is too thick for an arc of radius " + mm(std::min(Rr, Rc)),
        "it must be thinner than twice the smallest arc radius");
  if (leans && q - 2 * Rr <= t)
    add("root_arc_radius",
        "the convolution intersects itself: its neck at the root is " + mm(q - 2 * Rr) +
            " wide, the wall " + mm(t),
        "root_arc_radius must be below " + mm((q - t) / 2));
  if (leans && q - 2 * Rc <= t)
    add("crown_arc_radius",
        "neighbouring convolutions intersect: the gap between their crowns is " + mm(q - 2 * Rc) +
            ", the wall " + mm(t),
        "crown_arc_radius must be below " + mm((q - t) / 2));
}

} // namespace

double root_arc_radius(const MeridianSection& s) {
  return s.root_arc_radius > 0 ? s.root_arc_radius : s.pitch / 4;
}

double crown_arc_radius(const MeridianSection& s) {
  return s.crown_arc_radius > 0 ? s.crown_arc_radius : s.pitch / 4;
}

double axial_length(const MeridianSection& s) {
  switch (s.shape) {
  case SectionShape::cuff:
    return s.length;
  case SectionShape::points:
    return s.points.empty() ? 0 : s.count * s.points.back()[0];
  case SectionShape::u:
  case SectionShape::omega:
  case SectionShape::disc:
    break;
  }
  return s.count * s.pitch;
}

double axial_length(const Bellows& bellows) {
  double length = 0;
  for (const MeridianSection& s : bellows.profile) length += axial_length(s);
  return length;
}

double end_radius(const MeridianSection& s, double radius) {
  return s.shape == SectionShape::cuff && s.end_radius > 0 ? s.end_radius : radius;
}

std::array<double, 2> radius_range(const Bellows& bellows) {
  double radius = bellows.root_radius, low = radius, high = radius;
  for (const MeridianSection& s : bellows.profile) {
    if (s.shape != SectionShape::cuff) high = std::max(high, radius + s.height);
    for (const Point& p : s.points) {
      high = std::max(high, p[1]);
      low = std::min(low, p[1]);
    }
    radius = end_radius(s, radius);
    low = std::min(low, radius);
    high = std::max(high, radius);
  }
  return {low, high};
}

int convolutions(const Bellows& bellows) {
  int n = 0;
  for (const MeridianSection& s : bellows.profile)
    if (s.shape != SectionShape::cuff) n += s.count;
  return n;
}

double total_thickness(const Wall& wall) {
  double t = 0;
  for (const double ply : wall.plies) t += ply;
  return t;
}

std::vector<ProfileProblem> check_section(const MeridianSection& s, double radius, double t) {
  std::vector<ProfileProblem> problems;
  const double least = std::min(radius, end_radius(s, radius));
  if (t >= 2 * least)
    problems.push_back({"", "the wall of " + mm(t) + " is too thick for a radius of " + mm(least),
                        "it must be thinner than twice the radius"});
  const auto check_pitch = [&] {
    if (t >= s.pitch / 2 * (1 - slack))
      problems.push_back(
          {"pitch", "the wall of " + mm(t) + " does not fit twice into a pitch of " + mm(s.pitch),
           "pitch must be above " + mm(2 * t)});
  };
  switch (s.shape) {
  case SectionShape::cuff:
    break;
  case SectionShape::points:
    if (s.points.size() >= 2) check_points(s, radius, problems);
    break;
  case SectionShape::disc:
    check_pitch();
    break;
  case SectionShape::u:
  case SectionShape::omega:
    check_pitch();
    check_arcs(s, t, problems);
    break;
  }
  return problems;
}

} // namespace plica

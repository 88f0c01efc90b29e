#include "io/report/scene.hpp"

#include "io/report/visible.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace plica {
namespace {

// Share of x seen to the left and downwards: half length, at 40 degrees.
constexpr double oblique_left = 0.383, oblique_down = 0.321;

// What covers no pixel of the size it is shown at is left out.
constexpr int units_per_pixel = 2;

// "12 34" as SVG reads it, shortest: a minus sign separates too.
void append_pair(std::string& path, int x, int y) {
  fmt::format_to(std::back_inserter(path), "{}{}{}", x, y < 0 ? "" : " ", y);
}

std::string path_of(const Polygon& corners) {
  std::string path = "M";
  int last_x = 0, last_y = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const int x = static_cast<int>(std::lround(corners[i].x()));
    const int y = static_cast<int>(std::lround(corners[i].y()));
    if (i == 1) path += 'l';
    if (i > 1 && x - last_x >= 0) path += ' ';
    append_pair(path, x - last_x, y - last_y);
    last_x = x;
    last_y = y;
  }
  return corners.size() > 2 ? path + "z" : path;
}

// Light from above right, in front; the inside of a surface is darker.
double shade_of(Eigen::Vector3d normal, const View& view) {
  const bool is_inside = normal.dot(view.to_reader()) < 0;
  if (is_inside) normal = -normal;
  const Eigen::Vector3d light = (0.1 * view.right + 0.8 * view.up + 0.6 * view.towards);
  const double lit = (1 + normal.dot(light.normalized())) / 2;
  return std::pow(lit, 1.3) * (is_inside ? 0.6 : 1);
}

struct Item {
  double depth = 0;
  Polygon polygon;
  std::string colour;
};

Item item_of(const Scene& scene, const int* nodes, int count, const View& view,
             const Frame& frame) {
  Item item;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (int i = 0; i < count; ++i) {
    middle += scene.points[nodes[i]] / count;
    item.polygon.push_back(frame.place(view.project(scene.points[nodes[i]])));
  }
  double shade = 0.7;
  if (count == 4) {
    const Eigen::Vector3d diagonal = scene.points[nodes[2]] - scene.points[nodes[0]];
    const Eigen::Vector3d other = scene.points[nodes[3]] - scene.points[nodes[1]];
    shade = shade_of(diagonal.cross(other).normalized(), view);
  }
  item.depth = middle.dot(view.to_reader());
  item.colour = scene.colour(nodes, count, shade);
  return item;
}

// Corners of the convex hull, in order round it (Andrew's monotone chain).
std::vector<Eigen::Vector2d> hull(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  std::vector<Eigen::Vector2d> corners;
  const auto add_side = [&](auto first, auto last) {
    const std::size_t start = corners.size();
    for (auto point = first; point != last; ++point) {
      while (corners.size() >= start + 2) {
        const Eigen::Vector2d a = corners.back() - corners[corners.size() - 2];
        const Eigen::Vector2d b = *point - corners.back();
        if (a.x() * b.y() - a.y() * b.x() > 0) break;
        corners.pop_back();
      }
      corners.push_back(*point);
    }
    corners.pop_back();
  };
  add_side(points.begin(), points.end());
  add_side(points.rbegin(), points.rend());
  return corners;
}

} // namespace

Eigen::Vector2d View::project(const Eigen::Vector3d& point) const {
  const double near = point.dot(towards);
  return {point.dot(right) - oblique_left * near, point.dot(up) - oblique_down * near};
}

Eigen::Vector3d View::to_reader() const {
  return (towards + oblique_left * right + oblique_down * up).normalized();
}

View view_of(const std::vector<Eigen::Vector3d>& points) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  const Eigen::Vector3d size = box.isEmpty() ? Eigen::Vector3d::Ones() : box.sizes().eval();
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ();
  if (size.y() < 0.2 * std::min(size.x(), size.z())) return {x, z, -y};
  if (size.z() < 0.2 * std::min(size.x(), size.y())) return {x, y, z};
  return {y, z, x};
}

Eigen::Vector2d Frame::place(const Eigen::Vector2d& projected) const {
  return {scale * (projected.x() - origin.x()), scale * (origin.y() - projected.y())};
}

Frame frame_round(const View& view, const std::vector<Eigen::Vector3d>& points, double margin,
                  int width) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& point : points) box.extend(view.project(point));
  if (box.sizes().isZero(0)) margin = std::max(margin, 0.5); // a point, in a square of a metre
  const Eigen::Vector2d size = box.sizes() + Eigen::Vector2d::Constant(2 * margin);
  Frame frame;
  frame.width = width;
  frame.scale = width / std::max(size.x(), 0.6 * size.y()); // never much taller than wide
  frame.height = static_cast<int>(std::ceil(frame.scale * size.y()));
  const double left_over = width / frame.scale - size.x();
  frame.origin = {box.min().x() - margin - left_over / 2, box.max().y() + margin};
  return frame;
}

std::string drawn(const Scene& scene, const View& view, const Frame& frame) {
  std::vector<Item> items;
  for (const auto& quad : scene.quads) {
    items.push_back(item_of(scene, quad.data(), 4, view, frame));
  }
  for (const auto& line : scene.lines) {
    items.push_back(item_of(scene, line.data(), 2, view, frame));
  }
  std::stable_sort(items.begin(), items.end(),
                   [](const Item& a, const Item& b) { return a.depth < b.depth; });
  std::vector<Polygon> polygons;
  for (const Item& item : items) {
    polygons.push_back(item.polygon);
    for (Eigen::Vector2d& corner : polygons.back()) corner /= units_per_pixel;
  }
  const std::vector<bool> seen =
      visible(polygons, frame.width / units_per_pixel, frame.height / units_per_pixel);
  std::string svg = "<g class=\"quads\">\n";
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!seen[i]) continue;
    const bool is_line = items[i].polygon.size() == 2;
    svg += fmt::format("<path color=\"{}\"{} d=\"{}\"/>\n", items[i].colour,
                       is_line ? " stroke-width=\"8\"" : "", path_of(items[i].polygon));
  }
  return svg + "</g>\n";
}

std::string outline(const std::vector<Eigen::Vector3d>& points, const View& view,
                    const Frame& frame) {
  if (points.size() < 2) return "";
  std::vector<Eigen::Vector2d> placed;
  placed.reserve(points.size());
  for (const Eigen::Vector3d& point : points) placed.push_back(frame.place(view.project(point)));
  return "<path class=\"ghost\" d=\"" + path_of(hull(std::move(placed))) + "\"/>\n";
}

} // namespace plica

#include "io/report_visible.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

double side_of(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double x, double y) {
  return (to.x() - from.x()) * (y - from.y()) - (to.y() - from.y()) * (x - from.x());
}

bool contains(const Polygon& polygon, double x, double y) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const double side = side_of(polygon[i], polygon[(i + 1) % polygon.size()], x, y);
    left = left || side > 0;
    right = right || side < 0;
  }
  return !(left && right);
}

} // namespace

std::vector<bool> visible(const std::vector<Polygon>& polygons, int width, int height) {
  std::vector<int> canvas(static_cast<std::size_t>(width) * height, -1);
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (polygons[i].size() < 3) continue;
    Eigen::Vector2d low = polygons[i][0], high = low;
    for (const Eigen::Vector2d& corner : polygons[i]) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
    const int x1 = std::max(0, static_cast<int>(std::floor(low.x())));
    const int y1 = std::max(0, static_cast<int>(std::floor(low.y())));
    const int x2 = std::min(width - 1, static_cast<int>(std::ceil(high.x())));
    const int y2 = std::min(height - 1, static_cast<int>(std::ceil(high.y())));
    for (int y = y1; y <= y2; ++y) {
      for (int x = x1; x <= x2; ++x) {
        if (contains(polygons[i], x + 0.5, y + 0.5)) {
          canvas[static_cast<std::size_t>(y) * width + x] = static_cast<int>(i);
        }
      }
    }
  }
  std::vector<bool> seen(polygons.size(), false);
  for (std::size_t i = 0; i < polygons.size(); ++i) seen[i] = polygons[i].size() < 3;
  for (const int polygon : canvas) {
    if (polygon >= 0) seen[polygon] = true;
  }
  return seen;
}

} // namespace plica

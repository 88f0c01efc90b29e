#include "io/report/visible.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace plica {
namespace {

// Pixels [first, last] of a row whose centres lie in the polygon; last < first: none.
struct Span {
  int first = 0, last = -1;
};

Span span_at(const Polygon& polygon, double y, int width) {
  double left = width, right = -1;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a.y() < y) == (b.y() < y)) continue;
    const double x = a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y());
    left = std::min(left, x);
    right = std::max(right, x);
  }
  return {std::max(0, static_cast<int>(std::ceil(left - 0.5))),
          std::min(width - 1, static_cast<int>(std::floor(right - 0.5)))};
}

} // namespace

std::vector<bool> visible(const std::vector<Polygon>& polygons, int width, int height) {
  std::vector<int> canvas(static_cast<std::size_t>(width) * height, -1);
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (polygons[i].size() < 3) continue;
    double low = height, high = 0;
    for (const Eigen::Vector2d& corner : polygons[i]) {
      low = std::min(low, corner.y());
      high = std::max(high, corner.y());
    }
    const int last = std::min(height - 1, static_cast<int>(std::ceil(high)));
    for (int y = std::max(0, static_cast<int>(std::floor(low))); y <= last; ++y) {
      const Span span = span_at(polygons[i], y + 0.5, width);
      int* row = canvas.data() + static_cast<std::ptrdiff_t>(y) * width;
      for (int x = span.first; x <= span.last; ++x) row[x] = static_cast<int>(i);
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

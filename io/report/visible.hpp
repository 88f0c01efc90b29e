// Which polygons of a picture can be seen at all: hidden ones need not be written.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace plica {

using Polygon = std::vector<Eigen::Vector2d>; // convex; two corners: a line

// polygons[i] is painted over all before it on a canvas of width x height pixels. An entry is true
// when a pixel of it remains, or when it is a line.
std::vector<bool> visible(const std::vector<Polygon>& polygons, int width, int height);

} // namespace plica

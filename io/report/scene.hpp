// Projection, shading and order of the elements of a picture.
#pragma once

#include "mesh/mesh.hpp"

#include <functional>
#include <string>
#include <vector>

namespace plica {

// Orthonormal axes of the picture in the part frame, right-handed: right x up = towards the reader.
struct View {
  Eigen::Vector3d right, up, towards;
  // Picture plane: towards is drawn at half length, down to the left.
  Eigen::Vector2d project(const Eigen::Vector3d& point) const;
  // Direction to the reader along the projecting ray, unit length.
  Eigen::Vector3d to_reader() const;
};

View view_of(const std::vector<Eigen::Vector3d>& points);

// What is drawn: quads and lines between points; colour by the number of the point's element.
struct Scene {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<int, 4>> quads;
  std::vector<std::array<int, 2>> lines;
  // Colour of an element whose corners are given, at a shade 0..1.
  std::function<std::string(const int* corners, int count, double shade)> colour;
};

// Where the picture plane lies in the SVG: units of the view box, y down.
struct Frame {
  double scale = 1; // units per m
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  int width = 0, height = 0;
  Eigen::Vector2d place(const Eigen::Vector2d& projected) const;
};

// Frame of the given width round all points, `margin` (m) on each side.
Frame frame_round(const View& view, const std::vector<Eigen::Vector3d>& points, double margin,
                  int width);

// <g> of all elements that can be seen, far ones first.
std::string drawn(const Scene& scene, const View& view, const Frame& frame);

// <path> round all points (their convex hull), with the class "ghost".
std::string outline(const std::vector<Eigen::Vector3d>& points, const View& view,
                    const Frame& frame);

} // namespace plica

// Shapes of shell elements: corners, directors and thickness.
#pragma once

#include <Eigen/Core>

namespace plica {

struct ShellGeometry {
  Eigen::Matrix<double, 3, 4> X;         // corners, counter-clockwise seen from the director tips
  Eigen::Matrix<double, 3, 4> directors; // unit vectors
  Eigen::Vector4d thickness;             // m
};

struct TriangleGeometry {
  Eigen::Matrix3d X;         // corners in columns, counter-clockwise seen from the director tips
  Eigen::Matrix3d directors; // unit vectors in columns
  Eigen::Vector3d thickness; // m
};

} // namespace plica

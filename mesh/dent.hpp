// A dent: nodes within a radius of a place are pressed towards the axis.
//
//   u = -depth (1 - (s / radius)^2)^2 e,   s: distance from the place, e: from the axis to the
//   place
//
// The slope is zero at its edge. Directors turn with the surface; thickness stays. No residual
// stress.
#pragma once

#include "mesh/mesh.hpp"

namespace plica {

struct Dent {
  Eigen::Vector3d at{0, 0, 0};  // on the wall or near it, off the y axis
  double depth = 0, radius = 0; // m
};

// Number of nodes moved.
int press(Mesh& mesh, const Dent& dent);

} // namespace plica

// A flat or warped four-sided patch, meshed by bilinear interpolation of its corners.
//
// Directors are the normals of the bilinear surface. Sets: corner1..corner4, edge1..edge4 (edge k
// runs from corner k to corner k+1), all.
#pragma once

#include "mesh/mesh.hpp"

namespace plica {

// `along` elements from corner 1 to 2, `across` from corner 2 to 3. Thickness in m.
Mesh mesh_plate(const std::array<Eigen::Vector3d, 4>& corners, int along, int across,
                double thickness);

} // namespace plica

// Twenty-node bricks, one through the wall, over the turned meridian: what CalculiX makes of its
// eight-node shells, with all nodes on the true surfaces.
//
// Plies of bond fraction b: thickness t sqrt(f), modulus E / sqrt(f), density rho / sqrt(f) keep
// membrane and mass and bend by the factor f of the solid wall.
#pragma once

#include "wall.hpp"

namespace sealed {

struct MeridianSpot {
  Eigen::Vector2d at, normal; // (y, r), outward
};

// Ends and middles of the elements from left to right; `arc` elements per quarter, `flat` per wall.
std::vector<MeridianSpot> meridian_spots(const WallShape& shape, int arc, int flat, int cuff);

struct BrickMesh {
  int along = 0, around = 0;          // grid spots: 2 elements + 1, and 2 elements
  std::vector<MeridianSpot> meridian; // of the spots along
  std::vector<Eigen::Vector3d> nodes;
  std::vector<std::array<int, 20>> bricks; // numbers of nodes from 0, in CalculiX's order
  std::vector<double> factor;              // on E, of each brick
  // Nodes of a spot (along, around): below, above and, at corners, between; -1 = none.
  std::vector<std::array<int, 3>> columns;
  const std::array<int, 3>& column(int i, int j) const {
    return columns[std::size_t(i * around + j)];
  }
};

BrickMesh brick_mesh(const WallShape& shape, const WallSpecimen& s);

// Lower triangles of stiffness and mass over 3 unknowns a node, by `ccx` in that folder.
struct BrickMatrices {
  std::vector<Eigen::Triplet<double>> K, M;
};
BrickMatrices calculix_matrices(const WallShape& shape, const WallSpecimen& s,
                                const BrickMesh& mesh, const std::filesystem::path& folder);

} // namespace sealed

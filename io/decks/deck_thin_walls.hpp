// Profiles of thin straight walls: where they twist, how they resist twist and shear.
//
// A wall is a straight line with a thickness; walls that share an end are joined there. Shear flow
// q = t (h + dw/ds) under unit twist, h the lever of the wall about a pole, w the warping, and
// q = t dp/ds with dq/ds = -t f under a force whose stress grows by f along the beam: either is a
// flow through a net of resistances, solved at its nodes, so that open, closed and branched
// profiles of one or many cells are one case. Vlasov, Thin-Walled Elastic Beams (1961), chapter 1;
// Bredt (1896) for the cells.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace plica {

// From one end of its middle line to the other, (y, z), m; joints in the middle of a wall split it.
struct ThinWall {
  Eigen::Vector2d from, to;
  double thickness = 0;
};

struct ThinWallSection {
  Eigen::Vector2d shear_centre;     // (y, z), where the walls are drawn, m
  double J = 0;                     // Bredt's of the cells, b t^3 / 3 of walls outside of them, m4
  bool closed = false;              // it has a cell
  Eigen::Matrix2d shear_compliance; // strain energy V' C V / (2 G) of forces (Vy, Vz), 1/m2
};

// Throws std::invalid_argument for walls without length or thickness, or all along one line... of
// a plane without second moment both ways.
ThinWallSection thin_wall_section(const std::vector<ThinWall>& walls);

} // namespace plica

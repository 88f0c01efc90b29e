// Forces along beams of a deck as forces and moments on their nodes.
//
//   F = integral of N' p ds
//
// with the static shapes N of a beam that bends and shears, so that its nodes move, and are held,
// as those of the loaded beam. Axial force and moments by linear shapes. With the offsets of the
// beam the forces act on its axis. Source: Przemieniecki, Theory of Matrix Structural Analysis
// (1968), ch. 5.
#pragma once

#include "model/description/deck_model.hpp"

namespace plica {

// From `start` to `end`, as fractions of the length of the beam's axis: p1 there, p2 here, straight
// between, force per length along the unit vector `direction`. start = end: the force p1 there.
struct BeamLine {
  double start = 0, end = 1, p1 = 0, p2 = 0;
  Eigen::Vector3d direction{0, 0, 0};
};

// Added to `forces`. In the units of the deck.
void add_beam_load(std::vector<DeckForce>& forces, const DeckModel& deck, const BeamElement& beam,
                   const BeamLine& load);

} // namespace plica

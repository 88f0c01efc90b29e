// A spot of a wall, or of beams, that has lost some of its stiffness: on plates and on what is read
// from a file.
#pragma once

#include "diagnose/effects/effect.hpp"

namespace plica {

// Elements by their numbers among those of the model.
struct ElementList {
  std::vector<int> quads = {}, triangles = {}, beams = {};
};
// Shells get a section of their own for each that they had.
void halve_modulus(Model& model, const ElementList& elements);

// Elements of a part about a spot: those that meet there, and those beside them, one after the
// other, whose middle lies within a tenth of the root of its area; of beams alone, within a
// twentieth of the diagonal of their box. `halved` takes half of their modulus.
struct DamagedSpot {
  Spot spot;
  std::string way; // how large it is, where it is one of shells: "49 mm across"
  ModelChange halved;
};

// All over a plate, a surface or a deck (damage_spots); of others, and where nothing is a shell or
// a beam, none.
std::vector<DamagedSpot> damaged_spots(const Structure& s, const Part& part);

} // namespace plica

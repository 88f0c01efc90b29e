// What acts on the structure of a deck in one of its subcases or steps, in the units of the deck.
#pragma once

#include "solve/model.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace plica {

// Along the global axes of the deck; of a scalar point the first number alone.
struct DeckForce {
  int node = 0;
  Eigen::Vector3d force{0, 0, 0}, moment{0, 0, 0};
};

// Strain of free expansion, the same in all directions and all over an element.
struct DeckStrain {
  enum class Of { shell, beam, spring };
  Of of = Of::shell;
  int index = 0; // into DeckModel::shells, beams, springs
  double strain = 0;
};

struct DeckLoadCase {
  std::string name; // "subcase 2", "step 1"
  std::vector<DeckForce> forces;
  std::vector<DeckStrain> strains;             // other than zero
  bool along_beams = false;                    // some of the forces act between nodes of beams
  Eigen::Vector3d gravity{0, 0, 0};            // acceleration that acts on all masses
  std::vector<Constraint> supports;            // in place of those of the deck
  std::map<std::pair<int, int>, double> moved; // by node and DOF that a support holds: how far
  // What acts besides and is not had, or is wrong: "beam.bdf:12: PLOAD1 is not had".
  std::vector<std::string> not_had;
  std::vector<std::string> notes; // what else is to be known: "NLGEOM: solved linearly"
};

} // namespace plica

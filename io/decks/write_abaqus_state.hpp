// What moves the model of an Abaqus deck (write_abaqus.hpp) into the state of its case: a step
// *STATIC with NLGEOM before the modes.
//
// Nodes that follow a held cap rigidly are moved each by itself, also where the cap turns or grows
// with heat. Thermal strain is a rise of the temperature from 0 to 1, E is that of the state: the
// material of a hot section has its strain as its expansion. Springs stay along the global axes,
// forces keep their direction, and caps that are free or sprung follow their rows at rest: all
// three differ by the square of the rotation of the cap.
#pragma once

#include "model/shape/build.hpp"
#include "solve/acting_loads.hpp"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace plica {

// A number for a DOF of the model.
struct DofValue {
  int node = 0, dof = 0;
  double value = 0;
};

struct AbaqusState {
  std::map<int, int> carried;   // nodes that follow held ones rigidly, and which
  std::set<int> turned;         // held nodes that turn
  std::map<int, double> growth; // thermal strain of nodes that follow free ones rigidly
  std::vector<DofValue> moved;  // of held nodes and of those they carry
  std::vector<DofValue> pushed; // N, Nm; without the weight of masses
  Eigen::Vector3d gravity{0, 0, 0};
};

// `built`: as state_loads() leaves it, with its sections hot and under pressure. Throws InputError
// naming what the deck cannot hold.
AbaqusState abaqus_state(const Case& data, const BuiltCase& built, const StateLoads& loads);

// Capitals, digits and underscores: a name as a deck takes it.
std::string abaqus_name(std::string name);

// What else of the deck the step needs.
struct DeckOfState {
  // Where a DOF of the model stands, {node, dof} from 1; none: it has no such DOF.
  std::function<std::optional<std::pair<int, int>>(int node, int dof)> place;
  std::vector<std::string> heavy; // sets of elements with mass
  std::map<int, double> masses;   // kg, by their nodes in the deck
  int heat = 0; // node whose DOF 1 is the share of the heat that caps have; 0: none
};
// The static step, and the temperature at rest before it.
std::string abaqus_state_step(const BuiltCase& built, const AbaqusState& state,
                              const DeckOfState& deck);

} // namespace plica

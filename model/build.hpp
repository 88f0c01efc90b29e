// From a Case to a model that can be solved: meshes, sections, couplings, masses, supports.
#pragma once

#include "model/build_joints.hpp"
#include "model/case.hpp"
#include "solve/model.hpp"

namespace plica {

struct BuiltSensor {
  std::string name;
  int node = 0;
  double distance = 0;              // from the place in the case to the node, m
  std::array<int, 3> axes{1, 2, 3}; // as in Sensor
};

struct BuiltCase {
  Model model;
  std::vector<BuiltJoint> joints;       // with friction or nonlinear springs
  std::map<std::string, int> cap_nodes; // reference node of each cap
  std::vector<int> held_nodes;          // reference nodes of rigidly mounted caps
  std::vector<BuiltSensor> sensors;
  std::vector<std::array<double, 2>>
      meridian; // [y, r] of the shells of revolution that follow one another
};

// Throws InputError (key paths, no file or line) for what only the mesh can tell: a sensor off the
// part, a set that is not there, constraints that contradict each other.
// Stuck, the model bears the stiffness that its joints have in small motion.
BuiltCase build(const Case& data);

// Slipping, it bears what is left beside their friction. `plies`: of every bellows with `wall.slip`
// by its name, the laws of its plies from end to end; slipping_case() finds them, too. Throws
// std::out_of_range where one is missing.
using PlyLaws = std::map<std::string, std::vector<DirectionalLaw>>;
BuiltCase build_slipping(const Case& data, const PlyLaws& plies);

// Elements for a density: counts as given, or from the accuracy. The rule is measured (docs/
// elements.md): with the incompatible membrane the error of the axial stiffness is about 7 / N^2
// for N elements around (60 / N^2 with the others) and 0.7 % for 4 elements per quarter arc and 5
// per wall, falling with the square; half the accuracy goes to each direction. Arcs and walls
// longer than the bending length sqrt(R t) get more, in proportion.
struct ElementCounts {
  int around = 0, arc = 0, wall = 0;
};
ElementCounts element_counts(const Bellows& bellows);

} // namespace plica

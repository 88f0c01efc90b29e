// From a Case to a model that can be solved: meshes, sections, couplings, masses, supports.
#pragma once

#include "model/shape/build_joints.hpp"
#include "model/description/case.hpp"
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

} // namespace plica

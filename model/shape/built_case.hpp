// A model that can be solved, and what of the case lies where in it.
#pragma once

#include "model/shape/build_joints.hpp"

namespace plica {

struct BuiltSensor {
  std::string name;
  int node = 0;
  double distance = 0;              // from the place in the case to the node, m
  std::array<int, 3> axes{1, 2, 3}; // as in Sensor
};

struct BuiltCase {
  Model model;
  std::vector<BuiltJoint> joints; // with friction or nonlinear springs
  std::vector<BuiltDamper> dampers;
  std::map<std::string, int> cap_nodes;  // reference node of each cap
  std::map<std::string, int> end_nodes;  // of each end of a cap; across its springs another
  std::vector<int> held_nodes;           // reference nodes of rigidly mounted caps
  std::map<std::string, int> mass_nodes; // of each mass that is a part
  std::vector<BuiltSensor> sensors;
  std::vector<std::array<double, 2>>
      meridian; // [y, r] of the shells of revolution that follow one another
  // Where sensors sit beside the part (build_on_table of a diagnosis): of rigid mounts, by their
  // caps, a node of the fixture under the end; and nodes of the table.
  std::map<std::string, int> fixture_nodes = {};
  std::vector<int> table_nodes = {};
};

// Of every bellows with `wall.slip` by its name: the laws of its plies from end to end.
using PlyLaws = std::map<std::string, std::vector<DirectionalLaw>>;

} // namespace plica

// The model of a deck as a part of a case.
#pragma once

#include "mesh/shell_surface.hpp"
#include "model/description/deck_model.hpp"

namespace plica {

// Length and mass of one unit of the deck in m and kg; its forces follow with the second.
struct DeckUnits {
  double length = 1, mass = 1;
};

// What is done to a deck to make a part of it.
struct DeckPlacing {
  DeckUnits units = {};
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d move{0, 0, 0};
  bool held = true; // what the deck holds
  MembraneStrain membrane = MembraneStrain::incompatible;
};

// The deck as a model of one component. Normals that are not given are the mean of those of the
// facets that meet at less than 20 degrees, as in Abaqus. A wall beside its nodes has nodes of its
// own, which follow them rigidly. Single DOFs along axes that are not global become rows between
// the DOFs of their node. Nodes that nothing uses are left away; DOFs that no element and no
// constraint reaches are held. Throws std::runtime_error for a shell without area, or folded.
Model place(const DeckModel& deck, const DeckPlacing& placing);

} // namespace plica

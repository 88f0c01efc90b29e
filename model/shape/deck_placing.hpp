// What is done to a deck to make a part of it.
#pragma once

#include "mesh/shell_surface.hpp"
#include "model/description/deck_model.hpp"

namespace plica {

// Length and mass of one unit of the deck in m and kg; its forces follow with the second.
struct DeckUnits {
  double length = 1, mass = 1;
};

struct DeckPlacing {
  DeckUnits units = {};
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d move{0, 0, 0};
  bool held = true; // what the deck holds
  MembraneStrain membrane = MembraneStrain::incompatible;
};

} // namespace plica

// Loads of the strains that a deck has where it is hot.
//
//   F = sum_e K_e u_e,   u_e = strain (x - x_0)
//
// the motion by which an element that is alone grows, so that one that may grow bears nothing.
#pragma once

#include "model/description/deck_model.hpp"

#include <Eigen/Core>

namespace plica {

struct ExpansionLoads {
  Eigen::VectorXd force; // over the DOFs of the model that the deck makes
  double energy = 0;     // sum of u_e' K_e u_e / 2: what is stored where nothing gives way
};

// `placed`: what place() made of the deck.
ExpansionLoads expansion_loads(const DeckModel& deck, const Model& placed,
                               const std::vector<DeckStrain>& strains);

} // namespace plica

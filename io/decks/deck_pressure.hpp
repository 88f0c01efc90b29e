// Pressure on shells of a deck as forces on their nodes.
#pragma once

#include "model/description/deck_model.hpp"

namespace plica {

// F_a = integral of N_a p n dA over the flat facet of three or the bilinear one of four nodes, n
// the normal by the right-hand rule in the order of the nodes, p between those of the corners; in
// place of n a unit vector `along`, where it is not zero. Added to `forces`.
void add_pressure(std::vector<DeckForce>& forces, const std::vector<Eigen::Vector3d>& places,
                  const std::vector<int>& nodes, const std::vector<double>& pressure,
                  const Eigen::Vector3d& along);

} // namespace plica

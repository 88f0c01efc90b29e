// Mass of elements at their nodes alone, as bodies.
//
//   m_a = trace of sum_b M_ab / 3 over the translations = integral of rho t N_a in a shell,
//
// half of a bar at either end of its axis, and no inertia but that of a beam about its axis: so
// QUAD4 and BAR of NASTRAN-95 and the elements of MYSTRAN have it without PARAM COUPMASS, CBEAM of
// MSC Nastran with rho (I1 + I2) L / 2 about its axis, by its listings.
#pragma once

#include "solve/model.hpp"

#include <array>
#include <map>

namespace plica {

// From the first two nodes of an element to its ends, global axes.
using EndArms = std::array<Eigen::Vector3d, 2>;
inline EndArms no_arms() {
  return {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 0, 0)};
}

// Of every shell and beam of the model and of the matrices with the given numbers, whose masses are
// at their ends. Densities are zero afterwards.
void lump_masses(Model& model, const std::map<int, EndArms>& matrices);

} // namespace plica

// Damping of a run that real modes do not uncouple (solve/dissipation.hpp), from what the case
// states.
#pragma once

#include "model/shape/build.hpp"
#include "run/analyses/excitations.hpp"
#include "solve/dissipation.hpp"

namespace plica {

// The loads with a unit force in every damped spring behind them.
Loads with_dampers(Loads loads, const BuiltCase& built);

AddedStiffness added_by(const BuiltDamper& damper);

// Of a solution whose last loads are those; `excited`: what the others are, or null.
Dissipation dissipation(const Damping& damping, const BuiltCase& built,
                        const ModalSolution& solution, const Excitations* excited);

// Fractions of critical of each column, to first order: 2 zeta omega^2 = Im(L_jj + b_j' g b_j).
Eigen::VectorXd first_order_damping(const Dissipation& dissipation, const ModalSolution& solution);

} // namespace plica

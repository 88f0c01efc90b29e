// Loads at which a part in its state buckles, by its shells and by EJMA's formulas.
#pragma once

#include "model/description/case.hpp"
#include "run/results/state_results.hpp"
#include "solve/base_state.hpp"

namespace plica {

// As many loads as the state asks for; `acting`: on the model at rest. Bellows under pressure get
// the lowest of each kind in `squirm`, by the motion of their crowns: most of it once around and
// the tilts of neighbours alike, column, or against each other, in plane; most of it more often
// around, wall.
void add_buckling(const Case& data, const Model& at_rest, const StateLoads& acting,
                  const StateSolver& solver, StateResult& result);

// Of every bellows under pressure for which the formulas hold; the modulus is that at its highest
// temperature.
void add_squirm(const Case& data, StateResult& result);

} // namespace plica

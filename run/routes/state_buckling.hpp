// Loads at which a part in its state buckles, by its shells and by EJMA's formulas.
#pragma once

#include "model/description/case.hpp"
#include "run/results/state_results.hpp"
#include "solve/base_state.hpp"

namespace plica {

// `acting`: on the model at rest.
void add_buckling(int count, const Model& at_rest, const StateLoads& acting,
                  const StateSolver& solver, StateResult& result);

// Of every bellows under pressure for which the formulas hold; the modulus is that at its highest
// temperature.
void add_squirm(const Case& data, StateResult& result);

} // namespace plica

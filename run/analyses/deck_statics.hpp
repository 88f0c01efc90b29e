// Static analyses of the loads that decks among the parts give: K u = f for every subcase or step,
// linear, on the whole mesh, with what that subcase holds and moves in place of what the first one
// holds. Joints with friction stick. GRAV of a deck acts on all that the case has.
#pragma once

#include "model/shape/build.hpp"
#include "run/results/results.hpp"
#include "run/stages.hpp"

namespace plica {

struct DeckStatics {
  std::vector<DeckLoadResult> results;
  std::vector<std::string> notes;
  Eigen::MatrixXd u; // all DOFs of the model of the case x results
};

// `built`: the case as it is. Throws InputError (key analyses.static) with all that acts and is not
// had, where a deck has no load case, and for a structure that is not held.
DeckStatics deck_statics(const Case& data, const BuiltCase& built, const StageListener& stage);

} // namespace plica

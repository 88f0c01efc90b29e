// A case moved into its state and taken off its mount.
#pragma once

#include "model/shape/build.hpp"
#include "run/results/state_results.hpp"
#include "run/stages.hpp"

#include <map>

namespace plica {

struct ReleasedCase {
  BuiltCase built;
  StateResult state;
};
ReleasedCase released_in_state(const Case& data, const StageListener& stage,
                               std::map<std::string, double>& timing);

// Forces at these nodes when the part turns about the first of them and moves, six rows per node:
// the ends' forces turn with it. Of a moment half, since only the symmetric part of the stiffness
// of a moment of constant axis is in the model.
Eigen::MatrixXd forces_of_rigid_motions(const Case& data, const ReleasedCase& released,
                                        const std::vector<int>& nodes);

// Throws InputError where weight or a force inside would act on the superelement.
void check_reducible(const Case& data, const std::vector<std::string>& boundary);

} // namespace plica

// What a static rig reads between both caps.
#pragma once

#include "diagnose/gap/nominal.hpp"

#include <optional>

namespace plica {

// Of a reduced model's stiffness under change, spring mounts taken off. None: a part without two
// caps on the boundary, or so soft that nothing holds the ends together.
std::optional<double> rig_stiffness(const NominalState& state, const Eigen::MatrixXd& K,
                                    StaticDirection direction);

} // namespace plica

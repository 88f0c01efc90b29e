// What a static rig reads between both caps.
#pragma once

#include "diagnose/predict/nominal.hpp"
#include "solve/statics.hpp"

#include <optional>

namespace plica {

// Coordinates of two caps in a reduced model, six each; empty: there are no two that are called so
// on its boundary. `names`: none = the two of the case.
std::vector<int> cap_coordinates(const NominalState& state, std::vector<std::string> names = {});

// Of a reduced model's stiffness under change; nothing holds the feet of spring mounts. None: a
// part without two caps on the boundary, or so soft that nothing holds the ends together.
std::optional<EndStiffness> rig_stiffness(const NominalState& state, const Eigen::MatrixXd& K);
double along(const EndStiffness& k, StaticDirection direction);

} // namespace plica

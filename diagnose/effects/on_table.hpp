// A case as it stands on the table.
//
// Springs of a mount stand on a foot, a node of its own in the place of the cap, which the table
// holds: what gives way under them is done to the foot, and a static rig, which holds no foot, does
// not feel them, whatever they are.
#pragma once

#include "model/shape/build.hpp"

namespace plica {

// As build(), the feet among held_nodes.
BuiltCase build_on_table(const Case& data);

// What the table holds of a mount: the cap's node, or the foot of its springs.
int node_on_table(const BuiltCase& built, const Mount& mount);

// Of the model: the springs of a mount.
std::vector<int> springs_of(const Model& model, const Mount& mount);

} // namespace plica

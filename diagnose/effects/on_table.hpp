// A case as it stands on the table.
//
// Springs of a mount stand on a foot, a node of its own in the place of the cap, which the table
// holds: what gives way under them is done to the foot, and a static rig, which holds no foot, does
// not feel them, whatever they are.
#pragma once

#include "model/shape/build.hpp"

namespace plica {

// An end that a support holds in all directions is clamped as a mount clamps it, and may give way
// as that does: with a cap and a rigid mount in the place of each, named as the support is in the
// case, "supports[0]".
Case clamped_by_mounts(Case data);

// "mount.left", or that of a support.
std::string place_of(const Mount& mount);

// As build(), the feet among held_nodes.
BuiltCase build_on_table(const Case& data);

// What the table holds of a mount: the cap's node, or the foot of its springs.
int node_on_table(const BuiltCase& built, const Mount& mount);

// Of the model: the springs of a mount.
std::vector<int> springs_of(const Model& model, const Mount& mount);

} // namespace plica

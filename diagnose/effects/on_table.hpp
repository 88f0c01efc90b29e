// A case as it stands on the table.
//
// Springs of a mount stand on a foot, a node of its own in the place of the cap, which the table
// holds: what gives way under them is done to the foot, and a static rig, which holds no foot, does
// not feel them, whatever they are.
#pragma once

#include "lab/measured/measured.hpp"
#include "model/shape/build.hpp"

namespace plica {

// An end that a support holds in all directions is clamped as a mount clamps it, and may give way
// as that does: with a cap and a rigid mount in the place of each, named as the support is in the
// case, "supports[0]".
Case clamped_by_mounts(Case data);

// "mount.left", or that of a support.
std::string place_of(const Mount& mount);

// As build(), the feet among held_nodes. Sensors that sit beside the part come last. On a fixture
// they are rigid arms: of the foot of its springs, or of a node in the place of an end that is held
// rigidly, which the table holds beside it. A spring ties that node to the end, too soft to hold
// anything: where both are let go it goes where the end goes. On the table they do not move.
BuiltCase build_on_table(const Case& data);

// What the table holds of a mount: the cap's node, or the foot of its springs.
int node_on_table(const BuiltCase& built, const Mount& mount);

// Of the model: the springs of a mount.
std::vector<int> springs_of(const Model& model, const Mount& mount);

} // namespace plica

// Of a part that is free or hangs softly a test may list how it swings as a rigid body.
#pragma once

#include "diagnose/predict/nominal.hpp"

namespace plica {

// Leaves out modes of shape `other` and peaks that lie at the rigid motions of the model or not far
// above, with a warning each, and what shows along other axes there. The limit is the geometric
// mean of its highest rigid motion and its first mode, at least a fifth and at most half of the
// latter: a part may be far softer than its case. Orders and peaks that stay are counted from the
// first that is left. Throws InputError where nothing is.
void leave_out_rigid_motions(const Nominal& nominal, TestReadings& test);

} // namespace plica

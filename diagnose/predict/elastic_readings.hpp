// Of a part that is free or hangs softly a test may list how it swings as a rigid body.
#pragma once

#include "diagnose/predict/nominal.hpp"

namespace plica {

// Leaves out what lies below half of the first mode that the part has of its own, with a warning:
// rigid motions lie below a third of it. Modes that the test calls by a shape and order of their
// own stay. Orders and peaks behind are counted from the first that is left.
void leave_out_rigid_motions(const Nominal& nominal, TestReadings& test);

} // namespace plica

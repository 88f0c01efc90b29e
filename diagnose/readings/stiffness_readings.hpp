// Readings of dynamic stiffness that a rig measured: of each direction, kind and amplitude of a
// table some frequencies, |k| (or the storage, where there is no loss) and the loss factor
// Im k / |k|.
//
// At most six frequencies between the lowest and the highest of the table, three where it has
// amplitudes, of which at most four: neighbouring ones say the same. A standard deviation s of the
// complex stiffness over its magnitude is that of ln |k|, and s |k| / Im k that of ln (Im k / |k|);
// half of its square is common to a motion (weigh/uncertainty.cpp). A loss below twice its error
// says nothing. Where |k| changes with frequency an error of 0.3 % in that goes with it.
#pragma once

#include "diagnose/readings/reading_list.hpp"

namespace plica {

// Of all tables of the test; says what of them cannot be read.
void add_stiffness_readings(const Measured& measured, ReadingList& list);

} // namespace plica

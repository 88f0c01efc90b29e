// Where a record decays freely: after each hit, until the next one or until the noise.
//
// Level of a block of samples: RMS over all channels, each over its own RMS. A hit is a block
// above 0.3 of the highest that is three times one of the two before it; the decay starts behind
// the largest sample of the hit, or, where a channel of the force was recorded, behind the last
// sample of the contact that is above 5 % of its peak. It ends where the level stays within 1.5 of
// the noise, which is what was there before the first hit, or else the last twentieth of the
// record.
#pragma once

#include "lab/signals/time_record.hpp"

namespace plica {

struct DecayWindow {
  Eigen::Index first = 0, count = 0; // samples
};

// `force`: name of its channel, or empty. Throws InputError (key "file") for a record that does not
// decay, its last tenth still above half of the first behind the hit, and for a decay of fewer than
// 32 samples.
std::vector<DecayWindow> decay_windows(const TimeRecord& record, const std::string& force);

} // namespace plica

// Modes of responses to an excitation that nobody measured: covariance-driven stochastic subspace
// identification (covariance_ssi.hpp), the stabilisation diagram and its automatic reading.
//
// Poles are stable within 1 % in frequency and 30 % in damping and belong together within half a
// bandwidth, which is what they scatter by. A mode is that of its group which is known best (least
// deviation of the pole): at high orders poles split in two that are hardly known. So uncertainty
// reads the diagram, as in Reynders, Houbrechts and De Roeck, Mech. Syst. Signal Process. 29 (2012)
// 228-250. Its share is the RMS of what it gives to the correlations over that of the
// correlations, which are the free decays of the structure; `misfit` is what all leave of them.
//
// A peak of the densities, or a mode, whose band has the kurtosis of a sine (harmonics.hpp) is
// warned of as a harmonic of a machine.
//
// Limits: the excitation is white or at least flat across each mode: a colour of its own is a mode
// of the result. Damping is high by a few percent where the record is shorter than ten decay times.
#pragma once

#include "lab/identification/identify.hpp"
#include "lab/signals/time_record.hpp"

namespace plica {

// `set` of the result holds roots of Welch's densities, one reference. `settings.highest_order`
// counts pairs of poles, 0 = 30; without `settings.high` the band ends at highest_frequency().
// Throws InputError (keys "file", "channels", "rate") as check_record(), for a band beyond half the
// sampling rate, and for fewer samples than 20 blocks of correlations take.
Identification identify_output(const TimeRecord& record, const IdentifySettings& settings);

} // namespace plica

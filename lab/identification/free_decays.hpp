// Modes of free decays: the eigensystem realization algorithm, the stabilisation diagram and its
// automatic reading, then damped sinusoids by least squares.
//
//   H = [y_{i+j}], i = 0 .. p-1 below each other, j and the decays side by side = U S V'
//
// The leading 2, 4, .. columns of U S^1/2 give state-space models of rising order
// (state_space.hpp); stable poles start the fit (decay_fit.hpp), which gives the numbers and their
// standard deviations. Several decays, of one or several hits, are references of one set. Juang and
// Pappa, J. Guidance 8 (1985) 620-627.
//
// Consistency of a mode: EMAC of its outputs times its collinearity. EMAC compares the last block
// of U S^1/2 with C A^(p-1): 1 where the mode goes on as it began, near 0 for noise. Pappa, Elliott
// and Schenk, J. Guidance 16 (1993) 852-858, of which the part of the inputs is left out.
//
// Limits: linear, free of forces behind the hit (a longer one is cut off as long as the head of the
// decay is not explained, at most a sixth of it); the decays are cut to the shortest.
#pragma once

#include "lab/identification/identify.hpp"
#include "lab/signals/time_record.hpp"

namespace plica {

// `force`: the channel of the hammer in the records, or empty. `set` of the result has the spectra
// of the decays, `references` are these. `settings.highest_order` counts pairs of poles, 0 = 30;
// without `settings.high` the band ends at highest_frequency(). Throws InputError (keys "file",
// "channels", "rate") as check_record() and decay_windows(), for records of different channels or
// rates, and for a band beyond half the sampling rate.
Identification identify_decays(const std::vector<TimeRecord>& records, const std::string& force,
                               const IdentifySettings& settings);

} // namespace plica

// Peaks of measured responses at which no mode was found.
//
// Complex mode indicator function: the largest singular value of the matrix responses x references
// of each line, responses over their noise (Shih, Tsuei, Allemang and Brown, Mech. Syst. Signal
// Process. 2 (1988) 367-377). A peak that stands out of the valleys on both sides by a factor of
// three and is ten times the noise is a resonance; one without a mode within its half-power band,
// or within two lines of it, was missed. The number of modes is not checked: two in one peak pass.
#pragma once

#include "lab/identification/identification.hpp"

namespace plica {

Eigen::VectorXd mode_indicator(const FrfSet& set); // 1 = the noise

// Frequencies, increasing.
std::vector<double> missed_peaks(const FrfSet& set, const std::vector<IdentifiedMode>& modes);

} // namespace plica

// A mass that hangs on the structure by a spring of its own: a bracket, a shield, an absorber, a
// fluid that sloshes. Such a thing is no effect of the library: below its own resonance it is a
// mass, above it the ground, so that it explains what masses and supports explain, and more. What
// would be said to explain most has to stand up to it.
#pragma once

#include "diagnose/effects/effect.hpp"

namespace plica {

// At sensors and crowns, on their top and on their mean motion, and anywhere on beams and plates:
// of one frequency along all axes, damped as the structure is. Parameters: mass, frequency (Hz).
std::vector<Hypothesis> resonators(const Structure& s);

// "15 g on a spring of its own, which resonates at 805 Hz, at bellows.convolution[3]"
std::string words_of_resonator(const Hypothesis& h, const Eigen::VectorXd& values);

} // namespace plica

// Shock response spectrum: the largest absolute acceleration of an oscillator on a base that moves
// with the given acceleration, over the oscillator's frequency (ISO 18431-4; maximax, while the
// shock lasts and after it).
//
// Samples are joined by straight lines and the oscillators step without error of integration
// (oscillator.hpp); after the last sample the base keeps still and a whole period more is followed.
// The record is refined where a period has fewer than `steps_per_period` samples, so that a peak
// between samples is missed by less than 1 - cos(pi / steps_per_period).
#pragma once

#include <Eigen/Core>

namespace plica {

inline constexpr int steps_per_period = 24;

struct ShockSpectrum {
  Eigen::VectorXd hertz;
  Eigen::VectorXd positive, negative; // largest and smallest acceleration, in the unit of the shock
  Eigen::VectorXd maximax() const { return positive.cwiseMax(-negative); }
};

// hertz > 0; zeta = 1 / (2 Q) in [0, 1). Throws std::invalid_argument for anything else and for
// fewer than two samples.
ShockSpectrum shock_spectrum(const Eigen::VectorXd& acceleration, double dt,
                             const Eigen::VectorXd& hertz, double zeta);

} // namespace plica

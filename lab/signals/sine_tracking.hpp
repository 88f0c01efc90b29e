// Sine tests: amplitudes of the fundamental and its harmonics while the frequency steps or sweeps.
//
// Over a window around each wanted frequency every channel is fitted, by least squares, with
//
//   x(t) = a_0 + a_1 (t - t_0) + sum_k Re(A_k e^{i k phi(t)}),   k = 1 .. harmonics
//
// so that nothing leaks between orders and a whole number of periods is not needed. The phase phi
// is that of the reference channel (its analytic signal), or 2 pi f t where the frequency is known.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace plica {

// Amplitudes at one frequency: harmonics x channels; peak values, phase to the reference.
struct SineLine {
  double hertz = 0;
  double sweep_rate = 0; // (df/dt) / f there, 1/s; 0 while the frequency dwells
  Eigen::MatrixXcd amplitude;
  Eigen::VectorXd distortion; // per channel: sqrt(sum_{k>1} |A_k|^2) / |A_1|
  Eigen::VectorXd residual;   // per channel: RMS of what no harmonic explains / RMS of the signal
};

// Fit of one frequency over all samples, for those who know it; Plica itself tracks. Throws
// std::invalid_argument when the samples are too few or the highest harmonic lies above half the
// sampling rate.
SineLine fit_sine(const Eigen::MatrixXd& samples, double rate, double hertz, int harmonics);

struct SineTracking {
  int harmonics = 5;
  double cycles = 20; // length of the window; shorter blurs less, longer suppresses more noise
  double low = 0, high = 0; // Hz; 0 = what the sweep covers
  int lines = 400;          // wanted frequencies, evenly in the logarithm
};

// Swept or stepped sine whose reference channel (a column) carries the excitation. Where the
// frequency dwells, each step gives one line, of its second half; else one line per wanted
// frequency that the sweep passes. In increasing frequency. Harmonics above half the sampling rate
// are zero. A sweep that passes a frequency twice gives the first passage.
std::vector<SineLine> track_sine(const Eigen::MatrixXd& samples, double rate, int reference,
                                 const SineTracking& settings);

} // namespace plica

// Frequency responses of time signals to one of them.
#pragma once

#include "lab/measured/frf_set.hpp"
#include "lab/signals/frf_estimate.hpp"
#include "lab/signals/sine_tracking.hpp"

namespace plica {

struct SignalFrf {
  FrfSet set;                        // sigma from coherence and averages (noise), or none (sine)
  std::vector<std::string> channels; // of the signals, reference included
  Eigen::MatrixXd density;           // auto densities of noise, frequencies x channels, unit2/Hz
  Eigen::VectorXd rms;               // of noise over all frequencies, per channel
  Eigen::MatrixXd coherence;         // of noise, frequencies x responses
  Eigen::MatrixXd distortion;        // of the responses to a sine, frequencies x responses
};

// Samples with one channel a column, named by `channels`; `reference` is one of these.
// Throws std::invalid_argument when it is not there, and as welch() and track_sine().
SignalFrf frf_of_noise(const Eigen::MatrixXd& samples, double rate,
                       const std::vector<std::string>& channels, const std::string& reference,
                       FrfQuantity quantity, const WelchSettings& settings, FrfEstimator estimator);
SignalFrf frf_of_sine(const Eigen::MatrixXd& samples, double rate,
                      const std::vector<std::string>& channels, const std::string& reference,
                      FrfQuantity quantity, const SineTracking& settings);

} // namespace plica

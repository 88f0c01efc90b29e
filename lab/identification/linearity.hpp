// Is the structure linear? What changes with the level of excitation, harmonics, coherence,
// reciprocity.
#pragma once

#include "lab/measured/measured.hpp"

#include <Eigen/Core>

namespace plica {

// ln y = a + b ln level by least squares; `change` is y at the highest level over y at the lowest,
// minus one.
struct LevelSlope {
  double slope = 0, sigma = 0, change = 0;
  bool matters = false; // |slope| above three sigma and a change above one percent
};

struct LevelVerdict {
  std::string what;                                         // "base y, clamp y"
  std::vector<double> level, frequency, amplitude, damping; // the last two may be empty
  LevelSlope frequency_slope;
  std::optional<LevelSlope> amplitude_slope, damping_slope;
  bool linear = true;
  std::string verdict; // "linear within 0.4 % from 5 to 20", or "amplitude dependent: ..."
};

// Of peaks against level. Needs two levels; `sigma` is of the frequencies, 0 = not known: then
// their scatter about the line stands for it.
LevelVerdict level_verdict(const std::string& what, const std::vector<double>& level,
                           const std::vector<double>& frequency, double sigma,
                           const std::vector<double>& amplitude = {},
                           const std::vector<double>& damping = {});

// Of the peak tables of a test and of the highest peaks of responses measured at several levels.
std::vector<LevelVerdict> level_verdicts(const Measured& measured, const std::vector<FrfSet>& frfs);

// Responses to different references that should be equal, H_ij = H_ji.
struct Reciprocity {
  std::string a, b; // channels
  double frac = 0;
  double difference = 0; // RMS of H_ij - H_ji / RMS of both
};
std::vector<Reciprocity> reciprocity(const FrfSet& set);

// Same reference and responses at two levels: FRAC and RMS of the difference, of a linear structure
// 1 and noise.
struct Homogeneity {
  std::string reference, response;
  double level_a = 0, level_b = 0;
  double frac = 0, difference = 0;
};
std::vector<Homogeneity> homogeneity(const std::vector<FrfSet>& frfs);

// Of the four highest peaks of each response those at which the coherence is low: noise does not do
// that where the response is large.
struct CoherenceDrop {
  std::string response;
  double frequency = 0, coherence = 0;
};
std::vector<CoherenceDrop> coherence_drops(const FrfSet& set, const Eigen::MatrixXd& coherence,
                                           double below = 0.9);

// Largest harmonic distortion of each response to a sine, and where. `distortion` is frequencies x
// responses as frf_of_sine() gives it, or empty.
struct Distortion {
  std::string response;
  double frequency = 0, distortion = 0;
};
std::vector<Distortion> distortions(const FrfSet& set, const Eigen::MatrixXd& distortion);

// All that one setup tells about linearity.
struct LinearityOfSet {
  std::vector<Reciprocity> reciprocity;
  std::vector<CoherenceDrop> coherence_drops;
  std::vector<Distortion> distortion;
};

} // namespace plica

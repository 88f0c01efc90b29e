// Which of the eigenvalues found are given, and where they are counted: one rule for every route.
//
// `lambda` is increasing. `small`: size below which an eigenvalue is not told from zero, so that
// the rigid modes of a free body are one group; 0 when something holds it.
#pragma once

#include <Eigen/Core>
#include <array>

namespace plica {

struct ModesRequest {
  int count = 0;                    // number of modes, or 0 and
  std::array<double, 2> band{0, 0}; // every mode with a frequency in [low, high], Hz
  bool proof = true;
};

constexpr double lambda_pair_tolerance = 1e-5; // relative distance of lambda within a pair

// How many of the lowest are asked for; neither a pair nor the rigid modes are cut.
int modes_asked(const ModesRequest& request, const Eigen::VectorXd& lambda, double small);

// How many of the lowest lie below the band: not to be given. The partner of a mode in it stays.
int modes_below_band(const ModesRequest& request, const Eigen::VectorXd& lambda, double small);

// The widest gap with at least `keep` (1 or more) eigenvalues below it, among the first `known`.
// Where all known ones are one group, sigma lies 100 pair tolerances above.
struct SpectrumGap {
  int below = 0;    // eigenvalues
  double sigma = 0; // in its middle
};
SpectrumGap widest_gap(const Eigen::VectorXd& lambda, int keep, int known, double small);

} // namespace plica

// How well a hypothesis explains the readings, and how much it had to be bent for it.
//
//   e(z) = L^-1 (y_test - bias - y(z)),   Sigma = L L',   z ~ N(0, 1) per parameter
//   MAP: least e'e + z'z
//   ln Z ~ -1/2 (e'e + z'z) - 1/2 ln det(I + J'J),   J = de/dz                    (Laplace)
//
// What a hypothesis changes it does not change exactly: a law of slip is a law
// (Hypothesis::law_error), an effect does not act just so, and where modes come near each other, as
// they may in the changed structure only, what shows along other axes hangs on trifles. Such
// readings get a further covariance in proportion to their change, fixed at a first optimum, and
// ln Z loses half the growth of ln det Sigma. It is the same at every level, but for a law of slip,
// which errs at each level in its own way as well.
//
// Without a parameter, ln Z = -1/2 e'e: constants that all share are dropped. Transitional Markov
// chain Monte Carlo (Ching and Chen, J. Eng. Mech. 133 (2007) 816) gives ln Z on the same scale
// without the Gaussian shape, and draws of the posterior. The chains begin near the optima, with a
// tenth of them spread over the prior, which takes a few stages in place of twenty.
#pragma once

#include "diagnose/weigh/deviation.hpp"

namespace plica {

struct HypothesisFit {
  std::vector<const Hypothesis*> together; // one, or two of a pair; empty = nominal
  bool solved = false, complete = false;   // complete: with the deviations of what was held out
  Eigen::VectorXd z, values;
  std::vector<Eigen::VectorXd> others; // further optima, nearly as good: a sign that does not show
  Eigen::VectorXd deviation;  // log readings of the test less those of the hypothesis and bias
  Eigen::VectorXd error;      // e, of the fitted readings
  Eigen::MatrixXd J;          // de/dz
  Eigen::MatrixXd covariance; // of z
  double log_evidence = 0;
  std::optional<double> sampled_log_evidence; // by Markov chains
  Eigen::MatrixXd draws;                      // parameters x draws: z of the posterior
  double chi2 = 0;                            // e'e
  Eigen::MatrixXd further;                    // further covariance of all readings; empty = none
  double penalty = 0;                         // of ln Z, for these
  std::vector<Eigen::Index> aside;            // readings that do not follow the hypothesis
  double farthest = 0;                        // largest |z|
  int evaluations = 0;
};

HypothesisFit nominal_fit(const FitContext& context);
// `start`: coordinates to begin with, besides points spread over the prior; empty = these alone.
HypothesisFit fit_of(const FitContext& context, const std::vector<const Hypothesis*>& together,
                     const Eigen::VectorXd& start = {});

// ln Z at prior standard deviations times `width`, from the Gaussian at the optimum.
double log_evidence_at_width(const HypothesisFit& fit, double width);

// Fills in the deviations of readings that were held out, which fits leave aside.
void complete(const FitContext& context, HypothesisFit& fit);

// Fills draws and sampled_log_evidence.
void sample(const FitContext& context, HypothesisFit& fit, int particles, unsigned seed);

// "ply_slip at bellows", "added_mass at beam.point[3] (all round)"; pairs with "and".
std::string name_of(const HypothesisFit& fit);

} // namespace plica

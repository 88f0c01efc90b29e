// How well a hypothesis explains the readings, and how much it had to be bent for it.
//
//   e(z) = L^-1 (y_test - bias - y(z)),   Sigma = L L',   z ~ N(0, 1) per parameter
//   MAP: least e'e + z'z
//   ln Z ~ -1/2 (e'e + z'z) - 1/2 ln det(I + J'J),   J = de/dz                    (Laplace)
//
// Without a parameter, ln Z = -1/2 e'e: constants that all share are dropped. Transitional Markov
// chain Monte Carlo (Ching and Chen, J. Eng. Mech. 133 (2007) 816) gives ln Z on the same scale
// without the Gaussian shape, and draws of the posterior. The chains begin near the optimum, with a
// tenth of them spread over the prior, which takes a few stages in place of twenty.
#pragma once

#include "diagnose/gap/uncertainty.hpp"

#include <Eigen/Cholesky>

namespace plica {

// Readings that are fitted, whitened.
class Whitening {
public:
  Whitening(const TestReadings& test, const Uncertainty& u, bool held_out);

  // Of deviations from nominal and bias, over all readings.
  Eigen::VectorXd operator()(const Eigen::VectorXd& deviation) const;
  const std::vector<Eigen::Index>& rows() const { return rows_; }

private:
  std::vector<Eigen::Index> rows_;
  Eigen::LLT<Eigen::MatrixXd> root_;
};

struct HypothesisFit {
  std::vector<const Hypothesis*> together; // one, or two of a pair; empty = nominal
  bool solved = false;
  Eigen::VectorXd z, values;
  Eigen::VectorXd deviation;  // log readings of the test less those of the hypothesis and bias
  Eigen::VectorXd error;      // e, of the fitted readings
  Eigen::MatrixXd J;          // de/dz
  Eigen::MatrixXd covariance; // of z
  double log_evidence = 0;
  std::optional<double> sampled_log_evidence; // by Markov chains
  Eigen::MatrixXd draws;                      // parameters x draws: z of the posterior
  double chi2 = 0;                            // e'e
  double farthest = 0;                        // largest |z|
  int evaluations = 0;
};

// What all fits of one test share.
struct FitContext {
  PredictorStore& predictors;
  const TestReadings& test;
  const Uncertainty& uncertainty;
  const Eigen::VectorXd& measured; // log readings
  const Whitening& fitted;
};

HypothesisFit nominal_fit(const FitContext& context);
// `start`: coordinates to begin with, besides points spread over the prior; empty = these alone.
HypothesisFit fit_of(const FitContext& context, const std::vector<const Hypothesis*>& together,
                     const Eigen::VectorXd& start = {});

// ln Z at prior standard deviations times `width`, from the Gaussian at the optimum.
double log_evidence_at_width(const HypothesisFit& fit, double width);

// Fills draws and sampled_log_evidence.
void sample(const FitContext& context, HypothesisFit& fit, int particles, unsigned seed);

// "ply_slip at bellows", "added_mass at beam.point[3] (all round)"; pairs with "and".
std::string name_of(const HypothesisFit& fit);

} // namespace plica

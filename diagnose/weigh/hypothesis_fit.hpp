// A hypothesis, or several at once, fitted to the readings: what evidence.hpp finds of it.
#pragma once

#include "diagnose/effects/effect.hpp"

namespace plica {

struct HypothesisFit {
  std::vector<const Hypothesis*> together; // one, or several at once; empty = nominal
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
  Eigen::Index first_of(std::size_t member) const; // where the coordinates of a member begin
  std::vector<std::string> effects() const;        // of the members, sorted
};

} // namespace plica

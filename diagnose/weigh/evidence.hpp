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
#include "diagnose/weigh/hypothesis_fit.hpp"

namespace plica {

HypothesisFit nominal_fit(const FitContext& context);
// `start`: coordinates to begin with, besides points spread over the prior; empty = these alone.
HypothesisFit fit_of(const FitContext& context, const std::vector<const Hypothesis*>& together,
                     const Eigen::VectorXd& start = {});

// ln Z at prior standard deviations times `width`, from the Gaussian at the optimum.
double log_evidence_at_width(const HypothesisFit& fit, double width);

// Where a fit leaves more than the covariance of the readings allows, all errors are larger than
// stated by a factor that nobody knows. With the stated size worth four readings, e is a t variable
// of as many degrees of freedom,
//   ln Z ~ -1/2 (4 + n) ln(1 + e'e / 4) - 1/2 z'z - 1/2 ln det(I + J'J / d),
//   d = (4 + e'e) / (4 + n), at least 1:
// a hypothesis that leaves half of a large gap is not beyond doubt against one that leaves two
// thirds of it.
double dispersion(const HypothesisFit& fit);
double dispersed_log_evidence(const HypothesisFit& fit);
// Of the coordinates, by the Gaussian at the optimum.
Eigen::MatrixXd dispersed_covariance(const HypothesisFit& fit, double dispersion);

// Fills in the deviations of readings that were held out, which fits leave aside.
void complete(const FitContext& context, HypothesisFit& fit);

// Fills draws and, where errors are as stated (`dispersion` of 1), sampled_log_evidence.
void sample(const FitContext& context, HypothesisFit& fit, int particles, unsigned seed,
            double dispersion = 1);

} // namespace plica

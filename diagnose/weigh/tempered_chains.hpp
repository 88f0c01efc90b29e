// Transitional Markov chain Monte Carlo (Ching and Chen, J. Eng. Mech. 133 (2007) 816) of
// parameters with a standard normal prior, begun near known optima.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace plica {

// Where chains begin: the Gaussian at an optimum.
struct ChainStart {
  Eigen::VectorXd optimum;
  Eigen::MatrixXd covariance;
};

struct ChainDraws {
  Eigen::MatrixXd z;                  // parameters x particles, of the posterior
  std::optional<double> log_evidence; // ln of the likelihood over the prior; none: not converged
};

// Nine tenths of the chains begin near the starts, of which there is one at least, twice as wide as
// the Gaussian there; the rest are drawn from the prior, so that nothing it allows is out of reach.
// `log_likelihood` may be called from several threads; none where the point is impossible. The
// draws hang on the seed alone.
ChainDraws
tempered_chains(const std::vector<ChainStart>& starts,
                const std::function<std::optional<double>(const Eigen::VectorXd&)>& log_likelihood,
                int particles, unsigned seed);

} // namespace plica

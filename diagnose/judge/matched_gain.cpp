#include "diagnose/judge/matched_gain.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace plica {

using Eigen::MatrixXd;
using Eigen::VectorXd;

double gain_beside(const HypothesisFit& set, const Signature& s) {
  const MatrixXd& J = set.J;
  const MatrixXd A = MatrixXd::Identity(J.cols(), J.cols()) + J.transpose() * J;
  const VectorXd g = s.g - J * A.ldlt().solve(J.transpose() * s.g);
  return std::pow(g.dot(set.error), 2) / (2 * (g.squaredNorm() + 1)) -
         std::log1p(g.squaredNorm()) / 2;
}

double worth_of_one_more(const HypothesisFit& fit, const std::vector<Signature>& all) {
  const auto& together = fit.together;
  double most = 0;
  for (const Signature& s : all)
    if (!s.hypothesis->softening &&
        std::find(together.begin(), together.end(), s.hypothesis) == together.end())
      most = std::max(most, gain_beside(fit, s));
  return most;
}

} // namespace plica

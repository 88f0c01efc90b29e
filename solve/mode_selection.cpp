#include "solve/mode_selection.hpp"

#include "solve/modes_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::VectorXd;

// That modes m - 1 and m are one pair, or two rigid ones.
bool joined(const VectorXd& lambda, Eigen::Index m, double small) {
  return lambda[m] - lambda[m - 1] < lambda_pair_tolerance * std::max(std::abs(lambda[m]), small);
}

} // namespace

int modes_asked(const ModesRequest& request, const VectorXd& lambda, double small) {
  const auto all = lambda.size();
  Eigen::Index keep = request.count > 0
                          ? std::min<Eigen::Index>(request.count, all)
                          : Eigen::Index((lambda.array() <= eigenvalue(request.band[1])).count());
  while (keep > 0 && keep < all && joined(lambda, keep, small)) ++keep;
  return static_cast<int>(keep);
}

int modes_below_band(const ModesRequest& request, const VectorXd& lambda, double small) {
  if (request.count > 0 || request.band[0] <= 0) return 0;
  auto below = Eigen::Index((lambda.array() < eigenvalue(request.band[0])).count());
  while (below > 0 && below < lambda.size() && joined(lambda, below, small)) --below;
  return static_cast<int>(below);
}

SpectrumGap widest_gap(const VectorXd& lambda, int keep, int known, double small) {
  SpectrumGap best{.below = keep,
                   .sigma = lambda[keep - 1] + 100 * lambda_pair_tolerance *
                                                   std::max(std::abs(lambda[keep - 1]), small)};
  double widest = -1;
  for (int m = keep; m < known; ++m) {
    const double gap = (lambda[m] - lambda[m - 1]) / std::max(std::abs(lambda[m]), small);
    if (gap <= widest) continue;
    widest = gap;
    best = {.below = m, .sigma = lambda[m - 1] + 0.5 * (lambda[m] - lambda[m - 1])};
  }
  return best;
}

} // namespace plica

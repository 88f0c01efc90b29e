#include "compare/fit/fit_curves.hpp"

#include <algorithm>
#include <cmath>

namespace plica {

using Eigen::Index;
using Eigen::VectorXd;

std::optional<std::pair<VectorXd, VectorXd>> magnitudes(const std::vector<FrfSet>& simulated,
                                                        const FitCurve& curve) {
  for (const FrfSet& set : simulated)
    for (std::size_t r = 0; r < set.references.size(); ++r)
      for (std::size_t c = 0; c < set.responses.size(); ++c)
        if (set.references[r] == curve.reference && set.responses[c] == curve.response) {
          const VectorXd magnitude = set.H[r].col(Index(c)).cwiseAbs();
          if (!(magnitude.maxCoeff() > 0)) return std::nullopt;
          return std::pair{set.hertz, magnitude};
        }
  return std::nullopt;
}

VectorXd log_ratios(const FitCurve& curve, const VectorXd& hertz, const VectorXd& magnitude) {
  VectorXd ratio(Index(curve.hertz.size()));
  const double least = 1e-12 * magnitude.maxCoeff();
  for (std::size_t k = 0; k < curve.hertz.size(); ++k) {
    const auto above = std::upper_bound(hertz.begin(), hertz.end(), curve.hertz[k]);
    const Index i = std::clamp<Index>(above - hertz.begin(), 1, hertz.size() - 1);
    const double t = (curve.hertz[k] - hertz[i - 1]) / (hertz[i] - hertz[i - 1]);
    const double a = std::log(std::max(least, magnitude[i - 1])),
                 b = std::log(std::max(least, magnitude[i]));
    ratio[Index(k)] = a + t * (b - a) - curve.log_magnitude[k];
  }
  return ratio;
}

} // namespace plica

#include "lab/identification/missed_peaks.hpp"

#include "lab/signals/peaks.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace plica {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd mode_indicator(const FrfSet& set) {
  const Eigen::MatrixXd noise = noise_levels(set);
  VectorXd indicator(set.hertz.size());
  for (Index f = 0; f < set.hertz.size(); ++f) {
    Eigen::MatrixXcd H(Index(set.responses.size()), Index(set.H.size()));
    for (Index i = 0; i < H.cols(); ++i)
      H.col(i) = set.H[std::size_t(i)].row(f).transpose().cwiseQuotient(
          noise.col(i).cast<std::complex<double>>());
    indicator[f] =
        Eigen::JacobiSVD<Eigen::MatrixXcd>(H).singularValues()[0] / std::sqrt(double(H.size()));
  }
  return indicator;
}

std::vector<double> missed_peaks(const FrfSet& set, const std::vector<IdentifiedMode>& modes) {
  constexpr double prominence = 3, above_noise = 10;
  const VectorXd indicator = mode_indicator(set);
  std::vector<double> missed;
  for (const Peak& p : find_peaks(set.hertz, indicator, 0)) {
    Index at = 0;
    (set.hertz.array() - p.frequency).abs().minCoeff(&at);
    while (at > 0 && indicator[at - 1] > indicator[at]) --at;
    while (at + 1 < indicator.size() && indicator[at + 1] > indicator[at]) ++at;
    if (p.height < above_noise || indicator[at] < prominence * higher_valley(indicator, at))
      continue;
    const double line =
        set.hertz[std::min(at + 1, set.hertz.size() - 1)] - set.hertz[std::max<Index>(at - 1, 0)];
    const double low = std::min(std::isfinite(p.f1) ? p.f1 : p.frequency, p.frequency - line);
    const double high = std::max(std::isfinite(p.f2) ? p.f2 : p.frequency, p.frequency + line);
    if (std::none_of(modes.begin(), modes.end(), [&](const IdentifiedMode& m) {
          const double half = m.damping * m.frequency;
          return (m.frequency > low && m.frequency < high) ||
                 std::abs(m.frequency - p.frequency) < half;
        }))
      missed.push_back(p.frequency);
  }
  return missed;
}

} // namespace plica

#include "lab/identification/band_ends.hpp"
#include "lab/identification/pole_search.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;

constexpr double share = 0.1, clear = 3; // of the band, half-power bandwidths
constexpr Index least = 5;               // lines whose loss is worth a fit

double excess(double cut, double sigma_cut, double x, double sigma) {
  const double by_noise = std::max(0., sigma_cut * sigma_cut - sigma * sigma);
  return std::max(0., (cut - x) * (cut - x) - by_noise);
}

// Frequencies that are kept when one end is cut off.
std::pair<double, double> kept(const FrfSet& set, const ModalFit& fit, bool upper) {
  double low = set.hertz[0], high = set.hertz[set.hertz.size() - 1];
  const double away = share * (high - low);
  const FittedMode& outer = upper ? fit.modes.back() : fit.modes.front();
  const double reach = clear * 2 * outer.damping() * outer.frequency();
  if (upper)
    high = std::min(high, std::max(high - away, outer.frequency() + reach));
  else
    low = std::max(low, std::min(low + away, outer.frequency() - reach));
  return {low, high};
}

} // namespace

void widen_by_band_ends(const FrfSet& set, const ModalFit& fit,
                        std::vector<IdentifiedMode>& modes) {
  if (modes.empty() || modes.size() != fit.modes.size()) return;
  Poles poles;
  for (const FittedMode& m : fit.modes) poles.push_back(m.lambda);
  const auto count = Index(modes.size());
  Eigen::VectorXd frequency = Eigen::VectorXd::Zero(count), damping = frequency;
  for (const bool upper : {false, true}) {
    const auto [low, high] = kept(set, fit, upper);
    const FrfSet part = within(set, low, high);
    if (set.hertz.size() - part.hertz.size() < least || part.hertz.size() < 2 * count + least)
      continue;
    const ModalFit cut = fit_modes(part, poles);
    if (!cut.converged) continue;
    for (Index r = 0; r < count; ++r) {
      const FittedMode& m = cut.modes[std::size_t(r)];
      const FittedMode& as_fitted = fit.modes[std::size_t(r)];
      frequency[r] =
          std::max(frequency[r], excess(m.frequency(), m.sigma_frequency(), as_fitted.frequency(),
                                        as_fitted.sigma_frequency()));
      damping[r] = std::max(damping[r], excess(m.damping(), m.sigma_damping(), as_fitted.damping(),
                                               as_fitted.sigma_damping()));
    }
  }
  for (Index r = 0; r < count; ++r) {
    IdentifiedMode& mode = modes[std::size_t(r)];
    mode.sigma_frequency = std::hypot(mode.sigma_frequency, std::sqrt(frequency[r]));
    mode.sigma_damping = std::hypot(mode.sigma_damping, std::sqrt(damping[r]));
  }
}

} // namespace plica

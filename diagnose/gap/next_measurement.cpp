#include "diagnose/gap/next_measurement.hpp"

#include "diagnose/gap/menu.hpp"
#include "solve/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double beyond_doubt = 25;

std::string short_name(const RivalHypothesis& r) {
  std::string name = r.together.empty() ? "nothing" : "";
  for (const Hypothesis* h : r.together) name += (name.empty() ? "" : " and ") + h->effect;
  return name;
}

} // namespace

std::vector<ProposedMeasurement> next_measurements(const Case& data, const Measured& measured,
                                                   const TestReadings& test,
                                                   const std::vector<RivalHypothesis>& rivals) {
  if (rivals.size() < 2) return {};
  const Nominal plain = nominal_of(data, Measured{});
  std::vector<std::string> further;
  const Case equipped =
      with_further_sensors(plain.states.front().data, plain.structure(measured), further);
  Measured planned = measured;
  planned.states.clear();
  const Nominal nominal = nominal_of(equipped, planned);
  const std::vector<Offer> offers = menu(data, measured, test, further);
  std::vector<ProposedMeasurement> proposals(offers.size());
  in_parallel(int(offers.size()), [&](int o) {
    const Offer& offer = offers[std::size_t(o)];
    ProposedMeasurement& p = proposals[std::size_t(o)];
    p.what = offer.what;
    p.cost = offer.cost;
    std::vector<std::optional<VectorXd>> y;
    for (const RivalHypothesis& r : rivals)
      y.push_back(Predictor(nominal, offer.readings, r.together)(r.values));
    double most = 0;
    for (std::size_t i = 0; i < rivals.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        if (!y[i] || !y[j]) continue;
        double T = 0;
        for (Index k = 0; k < y[i]->size(); ++k) {
          const double d = (*y[i])[k] - (*y[j])[k];
          if (std::isfinite(d))
            T += std::pow(d / usual_sigma(offer.readings.readings[std::size_t(k)].kind), 2);
        }
        const double gain =
            rivals[i].probability * rivals[j].probability * std::min(T, beyond_doubt);
        p.separation += gain;
        if (gain > most) {
          most = gain;
          p.separates = short_name(rivals[j]) + " from " + short_name(rivals[i]);
        }
      }
  });
  double pairs = 0;
  for (std::size_t i = 0; i < rivals.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) pairs += rivals[i].probability * rivals[j].probability;
  for (ProposedMeasurement& p : proposals) p.separation /= std::max(pairs, 1e-12);
  std::erase_if(proposals, [](const ProposedMeasurement& p) { return p.separation < 1; });
  std::stable_sort(proposals.begin(), proposals.end(), [](const auto& a, const auto& b) {
    return a.separation / a.cost > b.separation / b.cost;
  });
  constexpr std::size_t most = 8;
  if (proposals.size() > most) proposals.resize(most);
  return proposals;
}

} // namespace plica

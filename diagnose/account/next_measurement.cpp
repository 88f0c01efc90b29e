#include "diagnose/account/next_measurement.hpp"

#include "diagnose/predict/menu.hpp"
#include "solve/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double told_apart = 9;
constexpr double open = 0.03; // probability from which a rival is to be told apart

std::string short_name(const RivalHypothesis& r) {
  std::string name = r.together.empty() ? "nothing" : "";
  for (const Hypothesis* h : r.together) name += (name.empty() ? "" : " and ") + h->effect;
  return name;
}

} // namespace

std::vector<ProposedMeasurement> next_measurements(const Case& data, const Nominal& nominal,
                                                   const Measured& measured,
                                                   const TestReadings& test,
                                                   const std::vector<RivalHypothesis>& rivals,
                                                   const std::shared_ptr<StateFamilies>& families) {
  if (rivals.size() < 2) return {};
  std::vector<Offer> offers = menu(data, measured, test, nominal.states.front().further_places());
  for (Offer& offer : offers) drop_unanswered(nominal, offer.readings, families);
  TestReadings together;
  std::vector<Index> first{0};
  for (const Offer& offer : offers) {
    append_readings(together, offer.readings);
    first.push_back(Index(together.readings.size()));
  }
  std::vector<std::optional<VectorXd>> y(rivals.size());
  in_parallel(int(rivals.size()), [&](int i) {
    const RivalHypothesis& r = rivals[std::size_t(i)];
    y[std::size_t(i)] = Predictor(nominal, together, r.together, families)(r.values);
  });
  // How far apart two rivals put what is offered, in squared standard deviations.
  const auto apart = [&](std::size_t o, std::size_t i, std::size_t j) {
    double T = 0;
    if (!y[i] || !y[j]) return T;
    for (Index k = first[o]; k < first[o + 1]; ++k) {
      const double d = (*y[i])[k] - (*y[j])[k];
      if (std::isfinite(d))
        T += std::pow(d / usual_sigma(together.readings[std::size_t(k)].kind), 2);
    }
    return T;
  };
  std::vector<ProposedMeasurement> proposals;
  for (std::size_t o = 0; o < offers.size(); ++o) {
    ProposedMeasurement p{
        .what = offers[o].what, .cost = offers[o].cost, .separates = "", .resolves = {}};
    double most = 0;
    for (std::size_t i = 0; i < rivals.size(); ++i) {
      double nearest = 1e300;
      for (std::size_t j = 0; j < rivals.size(); ++j) {
        if (i == j) continue;
        const double T = apart(o, i, j);
        if (rivals[j].probability > open) nearest = std::min(nearest, T);
        if (j > i) continue;
        const double gain =
            rivals[i].probability * rivals[j].probability * std::min(T, beyond_doubt);
        p.separation += gain;
        if (gain > most) {
          most = gain;
          p.separates = short_name(rivals[j]) + " from " + short_name(rivals[i]);
        }
      }
      if (nearest > told_apart && nearest < 1e299 && !rivals[i].together.empty())
        p.resolves.push_back(short_name(rivals[i]));
    }
    proposals.push_back(std::move(p));
  }
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

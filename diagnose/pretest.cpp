#include "diagnose/pretest.hpp"

#include "diagnose/effects/chosen_effects.hpp"
#include "diagnose/judge/identifiability.hpp"
#include "diagnose/predict/menu.hpp"
#include "model/description/end_caps.hpp"
#include "solve/parallel.hpp"
#include "words/directions.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int additions = 4;

TestPlan completed(TestPlan plan, const Case& data) {
  const auto& response = data.analyses.response;
  const auto& levels = data.analyses.levels;
  if (plan.bases.empty() && response) plan.bases = response->bases;
  if (plan.bases.empty() && levels) plan.bases = levels->bases;
  if (plan.bases.empty()) plan.bases = {1, 0};
  std::erase_if(plan.bases, [](int base) { return base > 2; });
  if (plan.levels.empty() && levels) plan.levels = levels->levels;
  if (plan.levels.empty() && response) plan.levels = {response->level};
  if (plan.levels.empty()) plan.levels = {1};
  return plan;
}

std::vector<std::string> sensors_of(const Case& data) {
  std::vector<std::string> names;
  for (const Sensor& s : data.sensors) names.push_back(s.name);
  return names;
}

TestReadings planned(const TestPlan& plan, const Case& data, std::vector<std::string>& words) {
  TestReadings all;
  const auto number = [&](ReadingKind kind, StaticDirection direction) {
    TestReadings one;
    Reading r;
    r.kind = kind;
    r.direction = direction;
    one.readings.push_back(r);
    append_readings(all, one);
  };
  if (plan.weighed) {
    number(ReadingKind::mass, {});
    words.emplace_back("the mass");
  }
  if (plan.pulled && !end_caps(data).empty()) {
    number(ReadingKind::stiffness, StaticDirection::axial);
    number(ReadingKind::stiffness, StaticDirection::transverse_x);
    words.emplace_back("the static stiffness along and across");
  }
  const std::vector<std::string> sensors = sensors_of(data);
  if (sensors.empty()) throw std::invalid_argument("the case has no sensors to plan with");
  for (int base : plan.bases)
    for (double level : plan.levels) {
      append_readings(all, sweep_readings(data, base, level, sensors.front(), sensors));
      words.push_back(fmt::format("a sweep along {} at {:g} m/s2", axis_word(base), level));
    }
  for (Reading& r : all.readings) r.sigma = usual_sigma(r.kind) / 2;
  return all;
}

// Sum over pairs of different effects of how far apart the nearest of their hypotheses are.
double apart(const std::vector<VectorXd>& g, const std::vector<Hypothesis>& all) {
  std::map<std::pair<std::string, std::string>, double> nearest;
  for (std::size_t i = 0; i < g.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (all[i].effect == all[j].effect) continue;
      const double own = g[i].squaredNorm(), other = g[j].squaredNorm();
      const double both = g[i].dot(g[j]);
      // What of the smaller one the larger one's direction does not explain.
      const double T = std::min(own, other) * (1 - both * both / std::max(own * other, 1e-300));
      auto& least = nearest.try_emplace({all[j].effect, all[i].effect}, 1e300).first->second;
      if (std::min(own, other) > 1) least = std::min(least, T);
    }
  double sum = 0;
  for (const auto& [pair, T] : nearest) sum += T < 1e299 ? std::min(T, beyond_doubt) : 0;
  return sum / double(std::max<std::size_t>(1, nearest.size()));
}

// What may be measured besides, and is not in the test.
OfferedReadings offers_beside(const Case& data, const Nominal& nominal, const TestReadings& test,
                              const std::shared_ptr<StateModels>& models) {
  std::vector<Offer> offers = menu(data, Measured{}, test, nominal.states.front().further_places());
  const auto has = [&](const Reading& r) {
    return r.run < 0 &&
           std::any_of(test.readings.begin(), test.readings.end(), [&](const Reading& t) {
             return t.kind == r.kind && t.direction == r.direction;
           });
  };
  for (Offer& offer : offers) drop_unanswered(nominal, offer.readings, models);
  std::erase_if(offers, [&](const Offer& o) {
    return o.readings.readings.empty() || has(o.readings.readings.front());
  });
  return in_one_list(std::move(offers));
}

// Whitened change of every offered reading by every hypothesis: by offer, then hypothesis.
std::vector<std::vector<VectorXd>> changes_of(const OfferedReadings& offered,
                                              const Nominal& nominal,
                                              const std::vector<Signature>& own,
                                              const std::vector<Hypothesis>& all,
                                              const std::shared_ptr<StateModels>& models) {
  const std::size_t count = offered.offers.size();
  const TestReadings& readings = offered.readings;
  const std::vector<Index>& first = offered.first;
  std::vector<std::vector<VectorXd>> change(count, std::vector<VectorXd>(all.size()));
  const auto y0 = Predictor(nominal, readings, {}, models)(VectorXd());
  in_parallel(int(all.size()), [&](int h) {
    const Predictor predict(nominal, readings, {&all[std::size_t(h)]}, models);
    const auto y = predict(predict.values_of(own[std::size_t(h)].z));
    for (std::size_t o = 0; o < count; ++o) {
      VectorXd d = VectorXd::Zero(first[o + 1] - first[o]);
      for (Index k = 0; k < d.size() && y && y0; ++k) {
        const double x = (*y)[first[o] + k] - (*y0)[first[o] + k];
        if (std::isfinite(x))
          d[k] = x / usual_sigma(readings.readings[std::size_t(first[o] + k)].kind);
      }
      change[o][std::size_t(h)] = d;
    }
  });
  return change;
}

std::vector<VectorXd> lengthened(std::vector<VectorXd> g, const std::vector<VectorXd>& by) {
  for (std::size_t h = 0; h < g.size(); ++h) {
    const Index n = g[h].size();
    g[h].conservativeResize(n + by[h].size());
    g[h].tail(by[h].size()) = by[h];
  }
  return g;
}

// Greedy: what helps most for its cost, then what helps most beside that.
std::vector<PlannedAddition> better(const Case& data, const Nominal& nominal,
                                    const TestReadings& test, const std::vector<Signature>& own,
                                    const std::vector<Hypothesis>& all,
                                    const std::shared_ptr<StateModels>& models) {
  const OfferedReadings offered = offers_beside(data, nominal, test, models);
  const std::vector<Offer>& offers = offered.offers;
  std::vector<std::vector<VectorXd>> change = changes_of(offered, nominal, own, all, models);
  std::vector<VectorXd> g;
  for (const Signature& s : own) g.push_back(s.g);
  std::vector<PlannedAddition> proposals;
  for (int round = 0; round < additions; ++round) {
    const double now = apart(g, all);
    std::size_t best = offers.size();
    double most = 0;
    for (std::size_t o = 0; o < offers.size(); ++o) {
      if (change[o].empty()) continue;
      const double then = apart(lengthened(g, change[o]), all);
      if (const double gain = (then - now) / offers[o].cost; gain > most) {
        most = gain;
        best = o;
      }
    }
    if (best == offers.size() || most < 1e-3) break;
    g = lengthened(std::move(g), change[best]);
    change[best].clear();
    proposals.push_back({offers[best].what, offers[best].cost, apart(g, all) - now});
  }
  return proposals;
}

} // namespace

Pretest pretest(const Case& data, const TestPlan& asked,
                const std::function<void(const std::string&)>& stage) {
  const TestPlan plan = completed(asked, data);
  Pretest result;
  result.case_name = data.name;
  stage("nominal case");
  Measured runs;
  for (int base : plan.bases) {
    MeasuredPeaks p;
    p.base = static_cast<Axis>(base);
    runs.peaks.push_back(p);
  }
  const Nominal nominal = nominal_of(data, runs);
  TestReadings test = planned(plan, data, result.plan);
  drop_unanswered(nominal, test);
  stage("admissible specimens");
  const Uncertainty u = uncertainty_of(data, nominal, test, runs, {});
  VectorXd measured = u.nominal;
  PredictorStore predictors(nominal, test);
  const Whitening fitted(test, u, false);
  const FitContext context{predictors, test, u, measured, fitted};
  std::vector<Hypothesis> all = chosen_effects(nominal.structure(runs)).hypotheses;
  std::erase_if(all, [](const Hypothesis& h) { return !h.between.empty(); }); // enough for a plan
  stage("signatures of " + std::to_string(all.size()) + " hypotheses");
  reduce_each(context, looked_at(all));
  std::vector<Signature> own = signatures(context, all);
  find_smallest(context, own);
  const Likeness alike = likeness(own);
  result.effects = alike.effects;
  result.likeness = alike.cosine;
  result.mimics = mimics(alike);
  result.detectable = detectable(own);
  stage("what to add");
  result.additions = better(data, nominal, test, own, all, predictors.models());
  return result;
}

} // namespace plica

#include "diagnose/account/told_apart.hpp"

#include "lab/measured/states.hpp"
#include "solve/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

// What sets would show in all that could be measured.
class MenuAnswers {
public:
  MenuAnswers(const GapProblem& problem, const OfferedReadings& menu,
              const std::vector<HypothesisFit>& sets)
      : menu_(menu), y_(std::min(most_told_apart, sets.size())) {
    in_parallel(int(y_.size()), [&](int i) {
      const HypothesisFit& set = sets[std::size_t(i)];
      y_[std::size_t(i)] = Predictor(problem.nominal, menu_.readings, set.together,
                                     problem.predictors->models())(set.values);
    });
  }

  std::size_t sets() const { return y_.size(); }

  // The best for its cost of what puts all pairs apart; empty: nothing does.
  std::string best_for(const Pairs& pairs) const {
    std::string best;
    double worth = 0;
    for (std::size_t o = 0; o < menu_.offers.size(); ++o) {
      double least = beyond_doubt;
      for (const auto& [a, b] : pairs) least = std::min(least, apart(o, a, b));
      if (least < well_apart || least / menu_.offers[o].cost <= worth) continue;
      worth = least / menu_.offers[o].cost;
      best = menu_.offers[o].what;
    }
    return best;
  }

private:
  double apart(std::size_t offer, std::size_t a, std::size_t b) const {
    return y_[a] && y_[b] ? menu_.apart(offer, *y_[a], *y_[b]) : 0;
  }

  const OfferedReadings& menu_;
  std::vector<std::optional<VectorXd>> y_;
};

// Which effect of a row a set holds; none: another set's alone.
std::optional<std::size_t> held_by(const HypothesisFit& set, const LedgerRow& row) {
  for (std::size_t e = 0; e < row.effects.size(); ++e)
    for (const Hypothesis* h : set.together)
      if (h->effect == row.effects[e].name && h->place == row.effects[e].place) return e;
  return std::nullopt;
}

// Sets that hold different effects of the row.
Pairs pairs_of(const LedgerRow& row, const std::vector<HypothesisFit>& told, std::size_t count) {
  Pairs pairs;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto a = held_by(told[i], row), b = held_by(told[j], row);
      if (a && b && *a != *b) pairs.emplace_back(i, j);
    }
  return pairs;
}

// What effects say of those that look like them, of the first two that do; empty: nothing of these.
std::string look_alikes_of(const LedgerRow& row, bool all_weighed) {
  for (const NamedEffect& a : row.effects)
    for (const NamedEffect& b : row.effects)
      for (const auto& [other, how, by_scale] : effect_named(a.name).look_alikes)
        if (other == b.name && !(by_scale && all_weighed))
          return row.effects.size() > 2 ? a.name + " from " + b.name + ": " + how : how;
  return "";
}

} // namespace

std::string say_what_tells_apart(const GapProblem& problem, const OfferedReadings& menu,
                                 const std::vector<HypothesisFit>& told, Ledger& ledger) {
  std::optional<MenuAnswers> answers;
  for (LedgerRow& row : ledger.rows) {
    if (row.effects.size() < 2) continue;
    if (!answers) answers.emplace(problem, menu, told);
    if (const Pairs pairs = pairs_of(row, told, answers->sets()); !pairs.empty())
      row.told_apart_by = answers->best_for(pairs);
    if (row.told_apart_by.empty())
      row.told_apart_by = look_alikes_of(row, is_weighed_in_all_states(problem.test.data));
  }
  if (!answers || answers->sets() == told.size()) return "";
  return fmt::format("what tells effects of a row apart is said of the best {} of {} sets that "
                     "explain the test alike",
                     answers->sets(), told.size());
}

} // namespace plica

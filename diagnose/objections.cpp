#include "diagnose/objections.hpp"

#include "diagnose/account/ledger.hpp"
#include "diagnose/account/shrink.hpp"
#include "diagnose/judge/thresholds.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

std::string foretold_no_better(const GapShrink& g) {
  return fmt::format("readings are foretold no better with it (shrink {:.0f} % [{:.0f}, {:.0f}])",
                     100 * g.shrink(), 100 * g.interval[0], 100 * g.interval[1]);
}

std::string closes_too_little(const Ledger& ledger, const char* where) {
  if (ledger.explained_interval[0] >= threshold::most_closed) return "";
  return fmt::format("it closes {:.0f} % of the gap [{:.0f}, {:.0f}]{}", 100 * ledger.explained,
                     100 * ledger.explained_interval[0], 100 * ledger.explained_interval[1], where);
}

// Where nothing explains the test, an effect that closes little may do so by what the others are
// off.
Objection members_of_little(const Ledger& ledger, const HypothesisFit& fit) {
  Objection found;
  if (fit.together.size() < 2) return found;
  for (std::size_t i = 0; i < fit.together.size(); ++i)
    if (ledger.rows[i].share < threshold::least_closed) {
      found.why = fmt::format("{} at {} closes {:.1f} % of the gap only", fit.together[i]->effect,
                              fit.together[i]->place, 100 * ledger.rows[i].share);
      found.small.push_back(fit.together[i]);
    }
  if (found.small.size() == fit.together.size()) found.small.clear();
  return found;
}

} // namespace

Referee Objections::referee() {
  return {.to_all = [this](const JudgedFit& j) { return to_all(j); },
          .to_sets = [this](const JudgedFit& j) { return to_sets(j); },
          .to_most = [this](const JudgedFit& j) { return to_most(j); }};
}

Objection Objections::to_all(const JudgedFit& leads) {
  const std::size_t readings = context_.fitted.rows().size();
  if (std::string rest = what_remains(leads); !rest.empty()) return {std::move(rest)};
  constexpr std::size_t fewest = 4;
  if (!problem_.held_out->rows().empty()) return {};
  const GapShrink turn = in_turn(context_, plain_, leads.fit);
  if (turn.interval[0] > 0) return {"", turn};
  const std::string found = "taken in turn, " + foretold_no_better(turn);
  if (readings >= fewest) return {found, turn};
  problem_.readings.warnings.push_back(name_of(leads.fit) + ": " + found);
  return {"", turn};
}

// Effects that each open a gap for the other to close are known by their difference, which errors
// of the model make as well.
Objection Objections::to_sets(const JudgedFit& leads) const {
  const MatrixXd shares = share_draws(context_, plain_, leads.fit, 1).shares;
  if (shares.cols() == 0) return {};
  double opened = 0;
  for (std::size_t i = 0; i < leads.fit.together.size(); ++i)
    opened -= std::min(0., shares(Index(i), 0));
  if (opened <= threshold::most_opened) return {};
  return {fmt::format("the effects cancel: some open {:.1f} times the gap, which the others close",
                      opened)};
}

Objection Objections::to_most(const JudgedFit& leads) {
  Objection found = to_most_alone(leads);
  if (!found.why.empty()) return found;
  beside_ = fit_beside(search_, leads);
  found.why = closes_too_little_beside(leads, *found.sampled);
  return found;
}

// Their own number of the gap that they close is not known better than the rest lets them be.
Objection Objections::to_most_alone(const JudgedFit& leads) const {
  if (std::string other = imitated(leads); !other.empty()) return {std::move(other)};
  HypothesisFit fit = leads.fit;
  sample(context_, fit, search_.settings.particles, 1, dispersion(fit));
  const Ledger ledger = ledger_of(context_, plain_, {{&fit}});
  if (std::string little = closes_too_little(ledger, ""); !little.empty())
    return {std::move(little), {}, std::move(fit)};
  if (Objection little = members_of_little(ledger, fit); !little.why.empty()) {
    little.sampled = std::move(fit);
    return little;
  }
  if (problem_.held_out->rows().empty()) {
    const GapShrink turn = in_turn(context_, plain_, leads.fit);
    return {turn.interval[0] > 0 ? "" : "taken in turn, " + foretold_no_better(turn), turn,
            std::move(fit)};
  }
  complete(context_, fit);
  const GapShrink held_out = gap_shrink(context_, *problem_.held_out, plain_, fit);
  return {held_out.interval[0] > 0 ? "" : "held-out " + foretold_no_better(held_out),
          {},
          std::move(fit)};
}

// Where others may act beside it; without any it was asked before.
std::string Objections::closes_too_little_beside(const JudgedFit& leads,
                                                 const HypothesisFit& sampled) const {
  std::vector<LedgerSet> others = sets_beside(leads, beside_, inclusion_);
  if (others.empty()) return "";
  others.push_back({.fit = &sampled});
  return closes_too_little(ledger_of(context_, plain_, others), " where others may act beside it");
}

// Effects that are such a factor themselves, or where a drawing may be as wrong, on a whole part.
bool Objections::is_like(const Compensator& c, const HypothesisFit& fit) const {
  static const std::multimap<FreeFactor, std::string> same{{FreeFactor::damping, "damping"},
                                                           {FreeFactor::modulus, "temperature"}},
      drawn{{FreeFactor::modulus, "ply_slip"},
            {FreeFactor::modulus, "component_stiffness"},
            {FreeFactor::modulus, "forming_thinning"},
            {FreeFactor::density, "unweighed_mass"}};
  const auto holds = [&](const auto& list) {
    return std::any_of(list.begin(), list.end(), [&](const auto& pair) {
      return pair.first == c.on &&
             std::any_of(fit.together.begin(), fit.together.end(),
                         [&](const Hypothesis* h) { return h->effect == pair.second; });
    });
  };
  return holds(same) || (problem_.baseline.readings.empty() && holds(drawn));
}

// One factor on everything that would leave no more of the gap.
std::string Objections::imitated(const JudgedFit& leads) const {
  for (const Compensator& c : tempting_)
    if (c.gap_after < threshold::one_factor * leads.gap_after && !is_like(c, leads.fit))
      return fmt::format("{} times {:.3g} would leave no more of the gap ({:.2g}, {:.2g} with it)",
                         c.name, c.factor, c.gap_after, leads.gap_after);
  return "";
}

// What explains the test closes half of its gap at least: errors may be smaller than they are
// stated, and then what is adequate leaves room for the cause. Beside a baseline an effect may be
// off by what it changes, so that much may remain of the gap.
std::string Objections::what_remains(const JudgedFit& leads) const {
  const double before = std::sqrt(plain_.chi2 / double(plain_.error.size()));
  if (problem_.baseline.readings.empty()) {
    const double closed = 1 - std::pow(leads.gap_after / before, 2);
    if (closed >= threshold::most_closed) return "";
    return fmt::format("it closes {:.0f} % of the gap", 100 * closed);
  }
  if (std::string other = imitated(leads); !other.empty()) return other;
  if (leads.gap_after < threshold::most_allowed || leads.gap_after < threshold::part_left * before)
    return "";
  return fmt::format("it leaves {:.0f} % of the change", 100 * leads.gap_after / before);
}

} // namespace plica

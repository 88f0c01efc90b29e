#include "diagnose/objections.hpp"

#include "diagnose/account/ledger.hpp"
#include "diagnose/account/shrink.hpp"
#include "diagnose/judge/reasons.hpp"
#include "diagnose/judge/thresholds.hpp"

#include <cmath>

namespace plica {

using Eigen::MatrixXd;

Referee Objections::referee() {
  return {.to_all = [this](const JudgedFit& j) { return to_all(j); },
          .to_sets = [this](const JudgedFit& j) { return to_sets(j); },
          .to_most = [this](const JudgedFit& j) { return to_most(j); }};
}

Objection Objections::to_all(const JudgedFit& leads) {
  if (std::string rest = what_remains(leads); !rest.empty()) return {std::move(rest)};
  if (leads.fit.together.front()->resonates)
    if (Objection found = outdone_by_resonator(leads, threshold::effects_apart); !found.why.empty())
      return found;
  if (!problem_.held_out->rows().empty()) return {};
  return foretells(leads, in_turn(context_, plain_, leads.fit), context_.fitted.rows().size());
}

Objection Objections::to_sets(const JudgedFit& leads) {
  const MatrixXd shares = share_draws(context_, plain_, leads.fit, 1).shares;
  if (shares.cols() == 0) return {};
  std::string why = cancel(shares.col(0).head(Eigen::Index(leads.fit.together.size())));
  if (!why.empty()) return {std::move(why)};
  return outdone_by_resonator(leads, threshold::effects_apart);
}

Objection Objections::to_most(const JudgedFit& leads) {
  Objection found = to_most_alone(leads);
  if (!found.why.empty()) return found;
  beside_ = fit_beside(search_, leads);
  found.why = closes_too_little_beside(leads, *found.sampled);
  if (!found.why.empty()) return found;
  Objection other = outdone_by_resonator(leads, -threshold::alike);
  found.why = std::move(other.why);
  found.resonator = std::move(other.resonator);
  return found;
}

// Their own number of the gap that they close is not known better than the rest lets them be.
Objection Objections::to_most_alone(const JudgedFit& leads) const {
  if (std::string other = imitated(leads, tempting_, beside_baseline()); !other.empty())
    return {std::move(other)};
  HypothesisFit fit = leads.fit;
  sample(context_, fit, search_.settings.particles, 1, dispersion(fit));
  const Ledger ledger = ledger_of(context_, plain_, {{&fit}});
  if (std::string little = closes_too_little(ledger); !little.empty())
    return {std::move(little), {}, std::move(fit)};
  if (Objection little = members_of_little(ledger, fit); !little.why.empty()) {
    little.sampled = std::move(fit);
    return little;
  }
  if (problem_.held_out->rows().empty()) {
    const GapShrink turn = in_turn(context_, plain_, leads.fit);
    return {in_turn_no_better(turn), turn, std::move(fit)};
  }
  complete(context_, fit);
  return {held_out_no_better(gap_shrink(context_, *problem_.held_out, plain_, fit)),
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

Objection Objections::outdone_by_resonator(const JudgedFit& leads, double nats_more) {
  Objection found;
  found.resonator = resonating_.instead_of(leads, nats_more);
  if (search_.settings.stop()) return {"the search was stopped"};
  if (found.resonator) found.why = "a mass on a spring of its own explains it";
  return found;
}

std::optional<JudgedFit> Objections::resonator_beyond(const Judgement& judgement) {
  if (search_.settings.stop()) return {};
  const bool at_the_edge =
      judgement.verdict == Verdict::ambiguous && judgement.named.front()->at_the_edge;
  if (judgement.verdict != Verdict::unknown && !at_the_edge) return {};
  return resonating_.instead_of(judgement.told(search_.nominal), threshold::effects_apart);
}

bool Objections::beside_baseline() const {
  return !problem_.baseline.readings.empty();
}

std::string Objections::what_remains(const JudgedFit& leads) const {
  const double before = std::sqrt(plain_.chi2 / double(plain_.error.size()));
  if (!beside_baseline()) return closes_less_than_half(leads, before);
  if (std::string other = imitated(leads, tempting_, true); !other.empty()) return other;
  return leaves_of_the_change(leads, before);
}

} // namespace plica

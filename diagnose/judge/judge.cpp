#include "diagnose/judge/judge.hpp"

#include "diagnose/judge/probabilities.hpp"
#include "diagnose/judge/thresholds.hpp"
#include "diagnose/weigh/fit_words.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <set>

namespace plica {
namespace {

constexpr double nothing_tried = -1e300; // nats

// What the best is worth that has these effects, wherever they sit.
double best_with(const std::vector<std::string>& names, const std::vector<EffectFits>& effects,
                 const std::vector<JudgedFit>& sets) {
  double best = nothing_tried;
  const auto ask = [&](const JudgedFit& j) {
    if (j.fit.effects() == names) best = std::max(best, evidence_of(j.fit));
  };
  for (const EffectFits& f : effects) ask(*f.best);
  for (const JudgedFit& j : sets) ask(j);
  return best;
}

// Whether a set is worth that much less without any of its members; `rest`: what the best is worth
// that has the others.
template <class Rest> bool each_is_needed(const JudgedFit& set, Rest rest) {
  return std::all_of(set.fit.together.begin(), set.fit.together.end(), [&](const Hypothesis* h) {
    return evidence_of(set.fit) - rest(*h) >= threshold::alike;
  });
}

bool needed_anywhere(const JudgedFit& set, const std::vector<EffectFits>& effects,
                     const std::vector<JudgedFit>& sets) {
  return each_is_needed(set, [&](const Hypothesis& member) {
    std::vector<std::string> others = set.fit.effects();
    others.erase(std::find(others.begin(), others.end(), member.effect));
    return best_with(others, effects, sets);
  });
}

bool needed_where_they_are(const JudgedFit& set, const Inclusion& inclusion) {
  return each_is_needed(set, [&](const Hypothesis& member) {
    const JudgedFit* rest = inclusion.without(set, {&member});
    return rest ? evidence_of(rest->fit) : nothing_tried;
  });
}

// Whether a set is far enough ahead of all that are smaller.
bool is_ahead(const JudgedFit& set, double none, const std::vector<EffectFits>& effects,
              const std::vector<JudgedFit>& sets) {
  double best = none;
  bool explained = false;
  const auto hold_against = [&](const JudgedFit& j) {
    best = std::max(best, evidence_of(j.fit));
    explained = explained || j.credible();
  };
  for (const EffectFits& f : effects) hold_against(*f.best);
  for (const JudgedFit& j : sets)
    if (j.fit.together.size() < set.fit.together.size()) hold_against(j);
  return evidence_of(set.fit) - best >=
         (explained ? threshold::beyond_chance : threshold::set_gain);
}

// Whether held-out readings, or readings in turn, speak for a set.
bool foretold(const JudgedFit& set) {
  return set.held_out_met && set.held_out_shrink.value_or(0) >= threshold::set_shrink;
}

// The best set that explains the test, foretells it and is far enough ahead of all smaller ones,
// and behind it all that are not told apart from it: of these some may be too far out of a prior,
// or foretell less.
std::vector<const JudgedFit*> standing_sets(double none, const std::vector<EffectFits>& effects,
                                            const std::vector<JudgedFit>& sets, double apart) {
  std::vector<const JudgedFit*> standing;
  for (const JudgedFit& set : sets)
    if (set.fit.solved && set.stands() && !set.too_free() && needed_anywhere(set, effects, sets))
      standing.push_back(&set);
  std::stable_sort(standing.begin(), standing.end(), [](const JudgedFit* a, const JudgedFit* b) {
    return evidence_of(a->fit) > evidence_of(b->fit);
  });
  const auto lead = std::find_if(standing.begin(), standing.end(), [&](const JudgedFit* set) {
    return set->credible() && foretold(*set) && is_ahead(*set, none, effects, sets);
  });
  if (lead == standing.end()) return {};
  const double most = evidence_of((*lead)->fit);
  std::rotate(standing.begin(), lead, lead + 1);
  std::erase_if(standing,
                [&](const JudgedFit* set) { return most - evidence_of(set->fit) >= apart; });
  return standing;
}

// What a law of slip is allowed to be off may hide what else acts: where that is a tenth of the
// gap, a set is not all of the cause, though it is adequate.
bool leaves_room(const JudgedFit& nominal, const JudgedFit& set) {
  return set.gap_after > threshold::most_allowed &&
         set.gap_after > std::sqrt(threshold::least_closed) * nominal.gap_after;
}

// Of standing sets the first of each choice of effects.
std::vector<const JudgedFit*> choices_of(const std::vector<const JudgedFit*>& standing) {
  std::vector<const JudgedFit*> first;
  std::set<std::vector<std::string>> seen;
  for (const JudgedFit* set : standing)
    if (seen.insert(set->fit.effects()).second) first.push_back(set);
  return first;
}

std::string alike_words(std::size_t sets) {
  return fmt::format("{} sets of effects explain the test alike", sets);
}

// What explains the test as well as what leads: an effect that closes none of the gap, which is not
// named, or several effects without it at its place. What leads is not sure then.
std::string outdone_by(const std::vector<EffectFits>& effects, const std::vector<JudgedFit>& sets,
                       const Inclusion& inclusion, const EffectFits& lead, double apart) {
  for (const EffectFits& f : effects)
    if (f.best->adequate && !f.best->fails_held_out && f.best->explains_nothing &&
        lead.log_evidence - f.log_evidence < apart)
      return name_of(f.best->fit) + " explains as much, and closes none of the gap";
  const std::string& place = lead.best->fit.together[0]->place;
  for (const JudgedFit& set : sets) {
    bool has_effect = false, has_lead = false;
    for (const Hypothesis* h : set.fit.together) {
      has_effect = has_effect || h->effect == lead.effect;
      has_lead = has_lead || (h->effect == lead.effect && h->place == place);
    }
    if (set.fit.solved && set.credible() && !set.too_free() && !has_lead &&
        lead.log_evidence - evidence_of(set.fit) < threshold::alike &&
        (has_effect ? needed_where_they_are(set, inclusion) : needed_anywhere(set, effects, sets)))
      return name_of(set.fit) + " explain as much";
  }
  return "";
}

constexpr const char* edge_words = "nine of ten healthy specimens leave less";
static_assert(threshold::sure == 0.9 && threshold::most_closed == 0.5, "words here say so");

// What was objected to what leads, if anything was.
void withhold(Objection& objection, Judgement& result) {
  result.withheld = std::move(objection.why);
  result.in_turn = objection.in_turn;
  result.sampled = std::move(objection.sampled);
  result.resonator = std::move(objection.resonator);
}

// Of a fit that does not lead any more.
void forget_what_was_asked(Judgement& result) {
  result.sampled.reset();
  result.in_turn.reset();
  result.resonator.reset();
}

// Effects that are told apart from all others, or a list of those that are not: `rivals` stand, but
// too far out of their priors to be named alone; `outdone`: why what leads is not sure.
void name_singles(const std::vector<const EffectFits*>& credible,
                  const std::vector<const EffectFits*>& rivals, const std::string& outdone,
                  const Standards& standards, const Objecting& objecting, Judgement& result) {
  const double best = credible.front()->log_evidence;
  for (const EffectFits* f : credible) {
    const double behind = best - f->log_evidence;
    const bool listed = result.named.size() < threshold::most_listed || behind < threshold::alike;
    if (behind < standards.apart && listed) result.named.push_back(f->best);
  }
  for (const EffectFits* f : rivals)
    if (best - f->log_evidence < standards.apart && result.named.size() < threshold::most_listed)
      result.named.push_back(f->best);
  result.withheld = result.named.front()->saturated();
  if (result.withheld.empty()) result.withheld = outdone;
  if (result.withheld.empty() && result.named.size() == 1 && result.named.front()->at_the_edge)
    result.withheld = edge_words;
  if (result.withheld.empty() && result.named.size() == 1 && objecting) {
    Objection objection = objecting(*result.named.front());
    result.warning = std::move(objection.warning);
    withhold(objection, result);
  }
  if (!result.withheld.empty())
    for (const EffectFits* f : credible)
      if (result.named.size() < threshold::most_listed &&
          best - f->log_evidence < threshold::open_to &&
          std::find(result.named.begin(), result.named.end(), f->best) == result.named.end())
        result.named.push_back(f->best);
  result.verdict = Verdict::ambiguous;
  if (result.named.size() == 1 && result.withheld.empty())
    result.verdict =
        result.named.front()->leaves_cause_open() ? Verdict::mostly : Verdict::identified;
  else
    weigh_with_doubt(standards.apart, result);
}

// Why effects that are far ahead are not said to explain most, before anybody is asked.
std::string short_of_most(const JudgedFit& nominal, const JudgedFit& lead) {
  if (lead.absurd) return "only with a value far out of its prior";
  if (lead.stays_at_priors) return "all its numbers stay at their priors";
  if (lead.too_free()) return "less than three readings for each free parameter";
  if (lead.held_out_shrink && *lead.held_out_shrink < threshold::set_shrink)
    return "held-out readings are hardly better with it";
  if (lead.gap_after > std::sqrt(1 - threshold::most_closed) * nominal.gap_after)
    return "it closes less than half of the gap";
  return "";
}

// Standing sets, or of these a list where the best is not believed, or where these are of different
// effects: what they share is as sure as any of a list then.
void name_sets(const JudgedFit& nominal, const std::vector<const JudgedFit*>& standing,
               const std::vector<const JudgedFit*>& different, const Objecting& objecting,
               Judgement& result) {
  const JudgedFit& lead = *standing.front();
  result.named = standing;
  result.verdict = lead.leaves_cause_open() ? Verdict::mostly : Verdict::several;
  weigh_standing(standing, result);
  if (lead.at_the_edge)
    result.withheld = edge_words;
  else if (objecting) {
    Objection objection = objecting(lead);
    withhold(objection, result);
  }
  double odds = threshold::even_odds;
  if (result.withheld.empty() && different.size() > 1) {
    result.withheld = alike_words(different.size());
    odds = threshold::shared_odds;
  }
  if (result.withheld.empty()) return;
  result.verdict = Verdict::ambiguous;
  result.named = different;
  claim_no_more_than_is_closed(nominal, &lead, odds, result);
}

// Effects that are far ahead and explain most, or nothing. Where members close too little, what is
// left of the set is asked about in its place.
void name_most(const JudgedFit& nominal, const Inclusion& inclusion, const Objecting& objecting,
               Judgement& result) {
  result.verdict = Verdict::unknown;
  result.nearest = inclusion.leading();
  const JudgedFit* lead = inclusion.leading_with(threshold::far_ahead);
  while (lead) {
    result.nearest = lead;
    result.withheld = short_of_most(nominal, *lead);
    Objection objection;
    if (result.withheld.empty() && objecting) {
      objection = objecting(*lead);
      withhold(objection, result);
    }
    if (result.withheld.empty()) {
      result.verdict = Verdict::mostly;
      result.named = {lead};
      return;
    }
    const JudgedFit* rest =
        objection.small.empty() ? nullptr : inclusion.without(*lead, objection.small);
    if (rest) forget_what_was_asked(result);
    lead = rest;
  }
}

} // namespace

Judgement nearest_so_far(const JudgedFit& nominal, const Inclusion& inclusion) {
  Judgement result;
  result.verdict = Verdict::unknown;
  result.nearest = inclusion.leading();
  result.stopped = true;
  weigh_all(inclusion, result);
  result.withheld = "the search was stopped";
  claim_no_more_than_is_closed(nominal, result.nearest, threshold::even_odds, result);
  return result;
}

Judgement judge(const JudgedFit& nominal, const std::vector<EffectFits>& effects,
                const std::vector<JudgedFit>& sets, const Inclusion& inclusion,
                const Standards& standards, const Referee& referee) {
  Judgement result;
  const double none = nominal.fit.log_evidence;
  std::vector<const EffectFits*> credible, rivals;
  for (const EffectFits& f : effects) {
    if (f.best->credible())
      credible.push_back(&f);
    else if (f.best->stands())
      rivals.push_back(&f);
  }
  weigh_singles(nominal, effects, result);
  const double best = credible.empty() ? nothing_tried : credible.front()->log_evidence;
  if (nominal.adequate && best - none < standards.evidence) {
    result.verdict = Verdict::none;
    return result;
  }
  const auto standing = standing_sets(none, effects, sets, standards.apart);
  const auto different = choices_of(standing);
  const bool few = different.size() <= threshold::most_listed;
  if (!standing.empty() && few && !leaves_room(nominal, *standing.front())) {
    name_sets(nominal, standing, different, referee.to_sets, result);
    return result;
  }
  if (!credible.empty() && best - none >= standards.evidence) {
    std::string outdone = outdone_by(effects, sets, inclusion, *credible.front(), standards.apart);
    if (outdone.empty() && !few) outdone = alike_words(different.size());
    name_singles(credible, rivals, outdone, standards, referee.to_all, result);
    if (!result.withheld.empty())
      claim_no_more_than_is_closed(nominal, result.named.front(), threshold::even_odds, result);
    return result;
  }
  weigh_all(inclusion, result);
  name_most(nominal, inclusion, referee.to_most, result);
  if (result.verdict == Verdict::unknown && !few) {
    result.verdict = Verdict::ambiguous;
    result.named = different;
    result.named.resize(threshold::most_listed);
    forget_what_was_asked(result);
    claim_no_more_than_is_closed(
        nominal, different.front(),
        result.withheld.empty() ? threshold::shared_odds : threshold::even_odds, result);
    result.withheld = alike_words(different.size());
  }
  if (result.verdict == Verdict::unknown)
    claim_no_more_than_is_closed(nominal, result.nearest,
                                 result.withheld.empty() ? 1 : threshold::even_odds, result);
  if (result.verdict == Verdict::unknown && !result.nearest && referee.mounted_anew) {
    result.verdict = Verdict::none;
    result.mounted_anew = true;
  }
  return result;
}

} // namespace plica

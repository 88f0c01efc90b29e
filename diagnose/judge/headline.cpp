#include "diagnose/judge/headline.hpp"

#include "diagnose/judge/reasons.hpp"
#include "diagnose/weigh/fit_words.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace plica {
namespace {

constexpr double worth_a_word = 0.05;

// Places but the named one that an effect may sit at as well, with `all` of its probability over
// them: ", beam.point[2] 30 %".
std::string named_elsewhere(const Judgement& judgement, const Hypothesis& named, double all) {
  constexpr int most = 3;
  const auto known = judgement.places.find(named.effect);
  if (known == judgement.places.end()) return "";
  std::string text;
  int told = 0;
  for (const auto& [place, share] : known->second)
    if (place != named.place && all * share > worth_a_word && told++ < most)
      text += fmt::format(", {} {:.0f} %", place, 100 * all * share);
  return text;
}

// How sure the place is, where it is not: "; the place 61 %, beam.point[2] 30 %".
std::string places(const Judgement& judgement, const Hypothesis& named) {
  constexpr double place_known = 0.95;
  const double own = judgement.share_of(named.effect, named.place);
  if (own > place_known || !judgement.places.contains(named.effect)) return "";
  return fmt::format("; the place {:.0f} %", 100 * own) + named_elsewhere(judgement, named, 1);
}

// "71 %", of G.
std::string closed(const JudgedFit& nominal, const JudgedFit& j) {
  const double left = j.gap_after / nominal.gap_after;
  return fmt::format("{:.0f} %", 100 * (1 - left * left));
}

std::string odds(double log_bayes) {
  if (log_bayes > 13.8) return "odds above a million to one";
  return fmt::format("odds {:.3g}:1", std::exp(log_bayes));
}

// One effect that explains all, beside the next.
std::string identified_words(const Judgement& judgement) {
  const JudgedFit& j = *judgement.named.front();
  const std::string& effect = j.fit.together[0]->effect;
  std::string text = name_of(j.fit) + " (" + odds(j.log_bayes_factor) + " over no effect";
  for (const auto& [name, p] : judgement.probabilities)
    if (name != effect && name != "none") {
      const double own = judgement.probability_of(effect);
      text += ", " + odds(std::log(std::max(own, 1e-300) / std::max(p, 1e-300))) + " over " + name;
      break;
    }
  return text + ")" + places(judgement, *j.fit.together[0]);
}

// "; what is no effect here would do better: 15 g on a spring of its own, which ..."
std::string resonator_words(const JudgedFit& nominal, const Judgement& judgement) {
  if (!judgement.resonator) return "";
  const JudgedFit& own = *judgement.resonator;
  return resonator_clause(judgement.resonator_is_ahead(nominal), words_of_last(own.fit)) +
         fmt::format(", which would leave a gap of {:.2g} ({:.2g} as it is told)", own.gap_after,
                     judgement.told(nominal).gap_after);
}

std::string ambiguous_words(const JudgedFit& nominal, const Judgement& judgement) {
  std::string text;
  for (const JudgedFit* j : judgement.named) {
    if (!text.empty()) text += judgement.names_sets() ? "; or " : " or ";
    text += name_of(j->fit);
    if (judgement.names_sets()) continue;
    const Hypothesis& h = *j->fit.together[0];
    const double anywhere = judgement.probability_of(h.effect);
    text += fmt::format(" {:.0f} %", 100 * anywhere * judgement.share_of(h.effect, h.place)) +
            named_elsewhere(judgement, h, anywhere);
  }
  if (judgement.names_sets())
    return "Ambiguous: " + text + "; " + judgement.withheld + resonator_words(nominal, judgement);
  text = (judgement.named.size() == 1 ? "Perhaps " : "Ambiguous: ") + text;
  if (!judgement.withheld.empty()) text += "; not identified: " + judgement.withheld;
  return text + resonator_words(nominal, judgement);
}

std::string several_words(const Judgement& judgement) {
  const JudgedFit& first = *judgement.named.front();
  std::string text = "Several effects: " + name_of(first.fit);
  const std::size_t others = judgement.named.size() - 1;
  if (others == 1) text += "; or " + name_of(judgement.named.back()->fit);
  text += " (" + odds(first.log_bayes_factor) + " over no effect)";
  return others < 2 ? text : text + fmt::format("; {} other sets explain the test as well", others);
}

std::string unknown_words(const JudgedFit& nominal, const Judgement& judgement) {
  const JudgedFit* j = judgement.nearest;
  if (judgement.stopped && !j)
    return "Stopped before an effect was found that comes nearer than the nominal case";
  if (judgement.stopped)
    return fmt::format("Stopped before all effects were tried; nearest so far comes {}, which "
                       "closes {} of the gap",
                       name_of(j->fit), closed(nominal, *j));
  const std::string withheld =
      judgement.withheld.empty() ? "" : "; not named: " + judgement.withheld;
  if (j && j->credible())
    return fmt::format("Not settled: {} would explain the test and close {} of the gap, not far "
                       "enough ahead of what else would{}",
                       name_of(j->fit), closed(nominal, *j),
                       withheld + resonator_words(nominal, judgement));
  std::string text = "None of the effects known here explains the test; it is farthest off in " +
                     nominal.worst.second;
  if (j)
    text += fmt::format("; nearest comes {}, which closes {} of the gap{}", name_of(j->fit),
                        closed(nominal, *j), withheld);
  return text + resonator_words(nominal, judgement);
}

} // namespace

std::string headline(const JudgedFit& nominal, const Judgement& judgement) {
  switch (judgement.verdict) {
  case Verdict::none:
    return "No effect: the nominal case explains the test within its uncertainties";
  case Verdict::identified:
    return identified_words(judgement);
  case Verdict::ambiguous:
    return ambiguous_words(nominal, judgement);
  case Verdict::several:
    return several_words(judgement);
  case Verdict::mostly: {
    const JudgedFit& j = *judgement.named.front();
    return fmt::format("Mostly {}: {} of the gap is closed, the rest is not explained{}",
                       name_of(j.fit), closed(nominal, j), places(judgement, *j.fit.together[0]));
  }
  case Verdict::unknown:
    break;
  }
  return unknown_words(nominal, judgement);
}

} // namespace plica

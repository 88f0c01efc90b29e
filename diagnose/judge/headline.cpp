#include "diagnose/judge/headline.hpp"

#include <array>
#include <cmath>
#include <fmt/core.h>
#include <fmt/printf.h>

namespace plica {
namespace {

// How sure the place is, where it is not: "; place 61 %, beam.point[2] 30 %".
std::string places(const Judgement& judgement, const Hypothesis& named) {
  constexpr double sure = 0.95, worth_a_word = 0.05;
  constexpr int most = 3;
  const double own = judgement.share_of(named.effect, named.place);
  const auto known = judgement.places.find(named.effect);
  if (own > sure || known == judgement.places.end()) return "";
  std::string text = fmt::format("; the place {:.0f} %", 100 * own);
  int told = 0;
  for (const auto& [place, share] : known->second)
    if (place != named.place && share > worth_a_word && told++ < most)
      text += fmt::format(", {} {:.0f} %", place, 100 * share);
  return text;
}

// "71 %", of G.
std::string closed(const JudgedFit& nominal, const JudgedFit& j) {
  const double left = j.gap_after / nominal.gap_after;
  return fmt::format("{:.0f} %", 100 * (1 - left * left));
}

} // namespace

std::string headline(const JudgedFit& nominal, const Judgement& judgement) {
  const auto odds = [](double log_bayes) {
    if (log_bayes > 13.8) return std::string("odds above a million to one");
    return fmt::format("odds {:.3g}:1", std::exp(log_bayes));
  };
  switch (judgement.verdict) {
  case Verdict::none:
    return "No effect: the nominal case explains the test within its uncertainties";
  case Verdict::identified: {
    const JudgedFit& j = *judgement.named.front();
    const std::string& effect = j.fit.together[0]->effect;
    std::string text = name_of(j.fit) + " (" + odds(j.log_bayes_factor) + " over no effect";
    for (const auto& [name, p] : judgement.probabilities)
      if (name != effect && name != "none") {
        const double own = judgement.probability_of(effect);
        text +=
            ", " + odds(std::log(std::max(own, 1e-300) / std::max(p, 1e-300))) + " over " + name;
        break;
      }
    return text + ")" + places(judgement, *j.fit.together[0]);
  }
  case Verdict::ambiguous: {
    if (judgement.names_sets()) {
      std::string text = "Ambiguous: ";
      for (const JudgedFit* j : judgement.named)
        text += (j == judgement.named.front() ? "" : "; or ") + name_of(j->fit);
      return text + "; " + judgement.withheld;
    }
    std::string text = judgement.named.size() == 1 ? "Perhaps " : "Ambiguous: ";
    for (const JudgedFit* j : judgement.named) {
      const Hypothesis& h = *j->fit.together[0];
      const double p = judgement.probability_of(h.effect) * judgement.share_of(h.effect, h.place);
      text += (j == judgement.named.front() ? "" : " or ") + name_of(j->fit) +
              fmt::format(" {:.0f} %", 100 * p);
    }
    return judgement.withheld.empty() ? text : text + "; not identified: " + judgement.withheld;
  }
  case Verdict::several: {
    const JudgedFit& first = *judgement.named.front();
    std::string text = "Several effects: " + name_of(first.fit);
    const std::size_t others = judgement.named.size() - 1;
    if (others == 1) text += "; or " + name_of(judgement.named.back()->fit);
    text += " (" + odds(first.log_bayes_factor) + " over no effect)";
    return others < 2 ? text
                      : text + fmt::format("; {} other sets explain the test as well", others);
  }
  case Verdict::mostly: {
    const JudgedFit& j = *judgement.named.front();
    return fmt::format("Mostly {}: {} of the gap is closed, the rest is not explained{}",
                       name_of(j.fit), closed(nominal, j), places(judgement, *j.fit.together[0]));
  }
  case Verdict::unknown:
    break;
  }
  if (judgement.stopped && !judgement.nearest)
    return "Stopped before an effect was found that comes nearer than the nominal case";
  if (judgement.stopped)
    return fmt::format(
        "Stopped before all effects were tried; nearest so far comes {}, which closes "
        "{} of the gap",
        name_of(judgement.nearest->fit), closed(nominal, *judgement.nearest));
  const std::string withheld =
      judgement.withheld.empty() ? "" : "; not named: " + judgement.withheld;
  const JudgedFit* j = judgement.nearest;
  if (j && j->credible())
    return fmt::format("Not settled: {} would explain the test and close {} of the gap, not far "
                       "enough ahead of what else would{}",
                       name_of(j->fit), closed(nominal, *j), withheld);
  std::string text = "None of the effects known here explains the test; it is farthest off in " +
                     nominal.worst.second;
  if (j)
    text += fmt::format("; nearest comes {}, which closes {} of the gap{}", name_of(j->fit),
                        closed(nominal, *j), withheld);
  return text;
}

} // namespace plica

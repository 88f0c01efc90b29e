#include "diagnose/judge/headline.hpp"

#include <array>
#include <cmath>
#include <fmt/core.h>
#include <fmt/printf.h>

namespace plica {

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
    std::string text = name_of(j.fit) + " (" + odds(j.log_bayes_factor) + " over no effect";
    for (const auto& [name, p] : judgement.probabilities)
      if (name != j.fit.together[0]->effect && name != "none") {
        double own = 0;
        for (const auto& [other, q] : judgement.probabilities)
          if (other == j.fit.together[0]->effect) own = q;
        text +=
            ", " + odds(std::log(std::max(own, 1e-300) / std::max(p, 1e-300))) + " over " + name;
        break;
      }
    return text + ")";
  }
  case Verdict::ambiguous: {
    std::string text = "Ambiguous: ";
    for (const JudgedFit* j : judgement.named) {
      double p = 0;
      for (const auto& [name, own] : judgement.probabilities)
        if (name == j->fit.together[0]->effect) p = own;
      text += (j == judgement.named.front() ? "" : " or ") + name_of(j->fit) +
              fmt::format(" {:.0f} %", 100 * p);
    }
    return text;
  }
  case Verdict::pair: {
    std::string text = "Two effects: ";
    for (const JudgedFit* pair : judgement.named)
      text += (pair == judgement.named.front() ? "" : "; or ") + name_of(pair->fit);
    return text + " (" + odds(judgement.named.front()->log_bayes_factor) + " over no effect)";
  }
  case Verdict::unknown:
    break;
  }
  return "None of the effects known here explains the test; it is farthest off in " +
         nominal.worst.second;
}

} // namespace plica

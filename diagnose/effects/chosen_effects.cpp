#include "diagnose/effects/chosen_effects.hpp"

#include "words/did_you_mean.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>
#include <tuple>

namespace plica {
namespace {

// As likely anywhere between its bounds, of itself or, nearly, of its logarithm: no wider one says
// less.
bool is_even(const Prior& prior) {
  if (prior.lies_between()) return true;
  const double range = prior.kind == PriorKind::log_normal ? std::log(prior.high / prior.low)
                                                           : prior.high - prior.low;
  return range <= 2 * prior.width;
}

// Whether there was something to widen, or to make narrower.
bool widen(Prior& prior, double factor) {
  if (prior.lies_between() || (factor >= 1 && is_even(prior))) return false;
  prior.width *= factor;
  return true;
}

class Choice {
public:
  explicit Choice(const Structure& s) : s_(s), asked_(s.data.diagnose) {}

  ChosenEffects chosen() {
    check_names(asked_.effects, "effects");
    check_names(asked_.without, "without");
    for (const Effect& effect : effects()) {
      if (!allowed(effect.name)) continue;
      std::vector<Hypothesis> own = effect.hypotheses(s_);
      if (own.empty()) result_.without_place.push_back(effect.name);
      for (Hypothesis& h : own) {
        all_places_.insert(h.place);
        if (sits_where_asked(s_.data, h)) result_.hypotheses.push_back(std::move(h));
      }
    }
    check_places();
    for (std::size_t i = 0; i < asked_.priors.size(); ++i) change_prior(i);
    if (problems_.empty() && result_.hypotheses.empty())
      refuse("effects", "leave nothing to be tried", "effects that the case has a place for");
    if (!problems_.empty()) throw InputError(std::move(problems_));
    look_at_those_alone(result_.hypotheses);
    say();
    return std::move(result_);
  }

private:
  void refuse(const std::string& key, std::string wrong, std::string allowed) {
    problems_.push_back({.file = "",
                         .line = 0,
                         .key = "diagnose." + key,
                         .wrong = std::move(wrong),
                         .allowed = std::move(allowed)});
  }

  void check_names(const std::vector<std::string>& names, const std::string& list) {
    for (std::size_t i = 0; i < names.size(); ++i)
      check_name(names[i], fmt::format("{}[{}]", list, i));
  }

  bool check_name(const std::string& name, const std::string& key) {
    std::vector<std::string> known;
    for (const Effect& e : effects()) known.push_back(e.name);
    if (std::find(known.begin(), known.end(), name) != known.end()) return true;
    refuse(key, "there is no effect '" + shown(name) + "'", suggestion(name, known));
    return false;
  }

  static bool named(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }
  bool allowed(const std::string& name) const {
    return (asked_.effects.empty() || named(asked_.effects, name)) && !named(asked_.without, name);
  }

  void check_places() {
    for (std::size_t i = 0; i < asked_.places.size(); ++i)
      if (std::none_of(all_places_.begin(), all_places_.end(), [&](const std::string& place) {
            return place.starts_with(asked_.places[i]);
          }))
        refuse(fmt::format("places[{}]", i),
               "no effect has a place '" + shown(asked_.places[i]) + "'",
               suggestion(asked_.places[i], {all_places_.begin(), all_places_.end()}));
  }

  void change_prior(std::size_t i) {
    const PriorRequest& asked = asked_.priors[i];
    const std::string key = fmt::format("priors[{}]", i);
    if (!check_name(asked.effect, key + ".effect")) return;
    if (!allowed(asked.effect)) {
      refuse(key + ".effect", asked.effect + " is not tried", "an effect that the case lets in");
      return;
    }
    std::vector<std::string> known;
    bool found = false, widened = false;
    std::set<std::string> places, empty; // of these, where nothing is left of the prior
    for (Hypothesis& h : result_.hypotheses) {
      if (h.effect != asked.effect) continue;
      for (EffectParameter& p : h.parameters) {
        if (!named(known, p.name)) known.push_back(p.name);
        if (p.name != asked.parameter) continue;
        found = true;
        if (asked.widening && widen(p.prior, *asked.widening)) widened = true;
        places.insert(h.place);
        if (asked.between.size() == 2 && !bound(p.prior, asked.between)) empty.insert(h.place);
      }
    }
    if (!known.empty() && !found)
      refuse(key + ".parameter",
             asked.effect + " has no parameter '" + shown(asked.parameter) + "'",
             suggestion(asked.parameter, known));
    const bool nowhere = empty == places;
    if (!nowhere) // a part may be too short for it
      std::erase_if(result_.hypotheses, [&](const Hypothesis& h) {
        return h.effect == asked.effect && empty.contains(h.place);
      });
    if (found && nowhere)
      refuse(key + ".between", "leaves nothing of the prior",
             "[low, high] that the parameter may have");
    if (found && asked.widening && !widened)
      refuse(key + ".widening", asked.parameter + " lies evenly between two bounds",
             "between: [low, high] within them");
    if (asked.between.empty() && !asked.widening)
      refuse(key, "changes nothing", "between: [low, high], or widening: 2");
  }

  static bool bound(Prior& prior, const std::vector<double>& between) {
    if (!(between[0] < between[1])) return false;
    if (prior.lies_between()) {
      prior.centre = std::max(prior.centre, between[0]);
      prior.width = std::min(prior.width, between[1]);
      return prior.centre < prior.width;
    }
    prior.low = between[0];
    prior.high = between[1];
    return prior.kind == PriorKind::normal || between[1] > 0;
  }

  void say() {
    if (!asked_.effects.empty())
      result_.words.push_back(
          fmt::format("only these effects are tried: {}", fmt::join(asked_.effects, ", ")));
    if (!asked_.without.empty())
      result_.words.push_back(fmt::format("effects left out: {}", fmt::join(asked_.without, ", ")));
    if (!asked_.places.empty())
      result_.words.push_back(fmt::format("effects sit only at places that begin with {}",
                                          fmt::join(asked_.places, ", ")));
    for (const PriorRequest& p : asked_.priors) {
      std::string text = "prior of " + p.effect + " " + p.parameter + ":";
      if (p.between.size() == 2)
        text += fmt::format(" between {:g} and {:g}", p.between[0], p.between[1]);
      if (p.widening) text += fmt::format(" {:g} times as wide", *p.widening);
      result_.words.push_back(std::move(text));
    }
  }

  const Structure& s_;
  const DiagnosisRequest& asked_;
  ChosenEffects result_;
  std::set<std::string> all_places_;
  std::vector<InputProblem> problems_;
};

} // namespace

ChosenEffects chosen_effects(const Structure& s) {
  return Choice(s).chosen();
}

void look_at_those_alone(std::vector<Hypothesis>& all) {
  std::set<std::tuple<std::string, std::string, std::string>> present;
  for (const Hypothesis& h : all) present.emplace(h.effect, h.place, h.way);
  for (Hypothesis& h : all)
    if (std::any_of(h.between.begin(), h.between.end(), [&](const auto& beside) {
          return !present.contains({h.effect, beside.first, h.way});
        }))
      h.between.clear();
}

bool sits_where_asked(const Case& data, const Hypothesis& h) {
  const std::vector<std::string>& places = data.diagnose.places;
  return places.empty() || h.place == "all" || h.place == "base" ||
         std::any_of(places.begin(), places.end(),
                     [&](const std::string& p) { return h.place.starts_with(p); });
}

} // namespace plica

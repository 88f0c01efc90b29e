#include "diagnose/suppose.hpp"

#include "diagnose/account/gap_problem.hpp"
#include "diagnose/account/ledger.hpp"
#include "words/did_you_mean.hpp"
#include "words/input_error.hpp"
#include "words/units.hpp"

#include <fmt/format.h>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// "20 g" of a parameter in kg. A parameter that the library gives no unit is a number.
ParsedQuantity number_of(const std::string& text, const std::string& unit) {
  for (const Dimension d :
       {Dimension::length, Dimension::mass, Dimension::stiffness, Dimension::rotational_stiffness,
        Dimension::frequency, Dimension::angle})
    if (const auto units = units_of(d); !units.empty() && units.front() == unit)
      return parse_quantity(text, d);
  return parse_quantity(text, unit.empty() ? Dimension::ratio : Dimension::number);
}

class Statement {
public:
  Statement(const GapProblem& problem, const Supposition& supposition) : problem_(problem) {
    constexpr std::size_t most = 6; // every subset of them is solved
    if (supposition.effects.size() > most)
      refuse("effects", fmt::format("{} effects at once", supposition.effects.size()),
             fmt::format("at most {}", most));
    else
      for (std::size_t i = 0; i < supposition.effects.size(); ++i)
        state(supposition.effects[i], fmt::format("effects[{}]", i));
    if (!problems_.empty()) throw InputError(std::move(problems_));
  }

  const std::vector<Hypothesis>& hypotheses() const { return stated_; }
  const std::vector<std::vector<EstimatedParameter>>& values() const { return values_; }

private:
  void refuse(const std::string& key, std::string wrong, std::string allowed) {
    problems_.push_back({.file = "",
                         .line = 0,
                         .key = key,
                         .wrong = std::move(wrong),
                         .allowed = std::move(allowed)});
  }

  // Distinct words of the hypotheses that pass, in their order.
  template <class Pass, class Word>
  std::vector<std::string> words(const Pass& passes, const Word& word) const {
    std::vector<std::string> all;
    for (const Hypothesis& h : problem_.hypotheses)
      if (passes(h) && std::find(all.begin(), all.end(), word(h)) == all.end())
        all.push_back(word(h));
    return all;
  }

  void state(const SupposedEffect& e, const std::string& key) {
    const auto effect = [&](const Hypothesis& h) { return h.effect == e.effect; };
    const auto there = [&](const Hypothesis& h) { return effect(h) && h.place == e.place; };
    for (const Hypothesis& h : problem_.hypotheses)
      if (there(h) && h.way == e.way) return take(h, e, key);
    if (words(effect, [](const Hypothesis& h) { return h.effect; }).empty())
      refuse(key + ".effect", "'" + shown(e.effect) + "' is not tried in this case",
             suggestion(e.effect, words([](const Hypothesis&) { return true; },
                                        [](const Hypothesis& h) { return h.effect; })));
    else if (words(there, [](const Hypothesis& h) { return h.place; }).empty())
      refuse(key + ".place", e.effect + " has no place '" + shown(e.place) + "'",
             suggestion(e.place, words(effect, [](const Hypothesis& h) { return h.place; })));
    else
      refuse(key + ".way", "'" + shown(e.way) + "' is none of its ways at " + e.place,
             suggestion(e.way, words(there, [](const Hypothesis& h) { return h.way; })));
  }

  // With priors that leave nothing open: coordinates of zero are what was stated.
  void take(Hypothesis h, const SupposedEffect& e, const std::string& key) {
    std::vector<std::string> known;
    for (const EffectParameter& p : h.parameters) known.push_back(p.name);
    for (const auto& [name, text] : e.value)
      if (std::find(known.begin(), known.end(), name) == known.end())
        refuse(key + ".value." + name, e.effect + " has no such parameter",
               suggestion(name, known));
    values_.emplace_back();
    for (EffectParameter& p : h.parameters) {
      const auto found = e.value.find(p.name);
      if (found == e.value.end()) {
        refuse(key + ".value." + p.name, "is missing",
               "the number of the effect" + (p.unit.empty() ? std::string() : ", in " + p.unit));
        continue;
      }
      const ParsedQuantity number = number_of(found->second, p.unit);
      if (!number.wrong.empty()) refuse(key + ".value." + p.name, number.wrong, number.allowed);
      if (p.prior.kind == PriorKind::log_normal && number.value < 0)
        refuse(key + ".value." + p.name, "is below 0", "0 or more");
      p.prior = {PriorKind::normal, number.value, 1};
      values_.back().push_back({p.name, p.unit, number.value, {number.value, number.value}, 0});
    }
    stated_.push_back(std::move(h));
  }

  const GapProblem& problem_;
  std::vector<Hypothesis> stated_;
  std::vector<std::vector<EstimatedParameter>> values_;
  std::vector<InputProblem> problems_;
};

} // namespace

Ledger suppose(const Case& data, const TestData& test, const Supposition& supposition,
               const DiagnosisSettings& settings) {
  const auto problem = stated_gap(data, test, settings);
  problem->predictors->solve_anew();
  const FitContext context = problem->context();
  const Statement statement(*problem, supposition);
  HypothesisFit fit;
  for (const Hypothesis& h : statement.hypotheses()) fit.together.push_back(&h);
  Index parameters = 0;
  for (const Hypothesis& h : statement.hypotheses()) parameters += Index(h.parameters.size());
  fit.z = VectorXd::Zero(parameters);
  fit.draws = Eigen::MatrixXd::Zero(parameters, 1);
  settings.stage("ledger", 0);
  const HypothesisFit nominal = nominal_fit(context);
  if (fit.together.empty()) return ledger_of(context, nominal, {});
  if (!Deviation(context, fit.together).at(fit.z))
    throw std::invalid_argument("with these effects the structure has no stable answer");
  Ledger ledger = ledger_of(context, nominal, {{&fit}});
  for (std::size_t i = 0; i < fit.together.size(); ++i) {
    const Hypothesis& h = *fit.together[i];
    ledger.rows[i].effects.push_back({.name = h.effect,
                                      .place = h.place,
                                      .way = h.way,
                                      .probability = 1,
                                      .parameters = statement.values()[i],
                                      .anywhere = 1});
  }
  return ledger;
}

} // namespace plica

#include "diagnose/account/account.hpp"

#include "diagnose/account/assumptions.hpp"
#include "diagnose/account/ledger.hpp"
#include "diagnose/account/named_effects.hpp"
#include "diagnose/account/overlays.hpp"
#include "diagnose/account/residual_energy.hpp"
#include "diagnose/account/shrink.hpp"
#include "diagnose/account/tried.hpp"
#include "diagnose/judge/headline.hpp"
#include "diagnose/judge/reasons.hpp"
#include "diagnose/judge/thresholds.hpp"
#include "diagnose/results/stage_share.hpp"
#include "diagnose/weigh/fit_words.hpp"
#include "lab/measured/measured_words.hpp"
#include "lab/measured/states.hpp"
#include "model/description/place_keys.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class Account {
public:
  Account(GapProblem& problem, const Findings& found, const DiagnosisSettings& settings)
      : problem_(problem), found_(found), settings_(settings), names_(problem, found) {}

  Diagnosis diagnosis() {
    const JudgedFit& nominal = found_.nominal;
    const Judgement& judgement = found_.judgement;
    const Told& told = found_.told;
    result_.case_name = problem_.data.name;
    result_.verdict = judgement.verdict;
    result_.probabilities = judgement.probabilities;
    result_.weighing = judgement.weighing;
    add_inclusion(judgement);
    std::vector<std::vector<NamedEffect>> members;
    for (const HypothesisFit& fit : told.fits) members.push_back(names_.members_of(fit));
    keep_ledger(members);
    add_effects(members);
    settings_.stage("report", share::report);
    result_.where = located(found_.scores, nominal.fit.deviation);
    for (LocatedGap& gap : residual_energy(problem_.nominal, problem_.readings, problem_.test.data))
      result_.where.push_back(std::move(gap));
    add_components(found_.ranked);
    Tried all = tried(problem_, found_, names_, *told.first);
    result_.tried = std::move(all.all);
    result_.best = all.best;
    for (const EffectFits& f : found_.ranked) result_.evaluations += f.best->fit.evaluations;
    how_far();
    add_resonator();
    add_trends(told.best);
    result_.basis_error = problem_.predictors->of(told.best.together).basis_error(told.best.values);
    result_.drifts = told.drifts;
    result_.compensators = found_.compensators;
    add_signatures();
    result_.overlays = overlays_of(problem_, told.best, told.second ? &*told.second : nullptr);
    add_posterior(told.best);
    if (told.second) add_posterior(*told.second);
    advise(judgement);
    result_.assumptions = assumptions_of(problem_, found_.standards, settings_.without);
    result_.warnings = problem_.readings.warnings;
    add_reach(told.best);
    result_.baseline = problem_.baseline;
    result_.hypotheses = int(problem_.hypotheses.size());
    result_.headline = headline_as_told();
    keep_picture();
    return std::move(result_);
  }

private:
  void add_inclusion(const Judgement& judgement) {
    for (const auto& [effect, places] : judgement.places) {
      const double probability = judgement.probability_of(effect);
      result_.inclusion.push_back({.effect = effect, .probability = probability, .places = places});
      for (auto& [place, share] : result_.inclusion.back().places) share *= probability;
    }
    std::stable_sort(result_.inclusion.begin(), result_.inclusion.end(),
                     [](const EffectInclusion& a, const EffectInclusion& b) {
                       return a.probability > b.probability;
                     });
  }

  // With places along a part as they stand beside the effects: of the same draws.
  std::string headline_as_told() const {
    Judgement judgement = found_.judgement;
    const std::vector<HypothesisFit>& fits = found_.told.fits;
    std::vector<JudgedFit> told;
    told.reserve(fits.size());
    const auto tell = [&](const JudgedFit*& judged) {
      told.push_back(*judged);
      told.back().fit = fits[told.size() - 1];
      judged = &told.back();
    };
    for (const JudgedFit*& judged : judgement.named)
      if (told.size() < fits.size()) tell(judged);
    if (judgement.named.empty() && judgement.nearest && !fits.empty()) tell(judgement.nearest);
    return headline(found_.nominal, judgement);
  }

  void keep_picture() {
    const Model& model = problem_.nominal.structure(problem_.test.data).built.model;
    result_.mesh = model.mesh;
    for (const BeamElement& b : model.beams) result_.lines.push_back({b.node1, b.node2});
  }

  // An ambiguous list is one row: each of it would explain that much. Of sets that explain the test
  // alike the rows are those of the first, each with what takes its place in the others, and draws
  // of all of them; of what leads draws beside further effects, too.
  void keep_ledger(const std::vector<std::vector<NamedEffect>>& members) {
    const Judgement& judgement = found_.judgement;
    const std::vector<HypothesisFit>& told = found_.told.fits;
    const bool list = judgement.verdict == Verdict::ambiguous && !judgement.names_sets();
    std::vector<LedgerSet> sets;
    for (std::size_t k = 0; k < told.size(); ++k) {
      LedgerSet set{.fit = &told[k], .members = in_place_of(members.front(), members[k])};
      constexpr double least = 1e-3;
      if (list)
        set.weight = std::max(least, judgement.probability_of(told[k].together[0]->effect));
      else if (k > 0)
        set.weight = beside_the_first(*judgement.named[k]);
      if (std::all_of(set.members.begin(), set.members.end(),
                      [&](std::size_t member) { return member < members[k].size(); }))
        sets.push_back(std::move(set));
    }
    for (LedgerSet& set : sets_beside(*found_.told.first, found_.beside, found_.inclusion))
      sets.push_back(std::move(set));
    const bool alone = sets.empty() || judgement.is_settled();
    result_.ledger = ledger_of(found_.context, found_.nominal.fit, sets,
                               alone ? 0 : weight_of_something_else(told, sets));
    if (members.empty()) return;
    std::vector<std::vector<NamedEffect>> groups = alternatives(members);
    for (std::size_t i = 0; i < groups.size(); ++i)
      result_.ledger.rows[i].effects = std::move(groups[i]);
  }

  // What is not settled has no more of the gap than it is probable: of a list any of it, of sets
  // what they share.
  double weight_of_something_else(const std::vector<HypothesisFit>& told,
                                  const std::vector<LedgerSet>& sets) const {
    double weight = 0, probability = 0;
    for (const LedgerSet& set : sets) weight += set.weight;
    if (told.front().together.size() == 1)
      for (const HypothesisFit& fit : told)
        probability += found_.judgement.probability_of(fit.together[0]->effect);
    else
      for (const Hypothesis* h : told.front().together)
        probability = std::max(probability, found_.judgement.probability_of(h->effect));
    probability = std::clamp(probability, 1e-3, 1.);
    return weight * (1 - probability) / probability;
  }

  // Each once, of twins each, wherever sets that are named share it.
  void add_effects(const std::vector<std::vector<NamedEffect>>& members) {
    for (std::size_t i = 0; i < found_.judgement.named.size(); ++i) {
      const std::vector<NamedEffect>& set = members[i];
      for (auto e = set.begin(); e != set.end(); ++e) {
        const auto alike = [&](const NamedEffect& other) { return is_same(other, *e); };
        const auto& told = result_.effects;
        if (std::count_if(told.begin(), told.end(), alike) <= std::count_if(set.begin(), e, alike))
          result_.effects.push_back(*e);
      }
    }
  }

  void add_signatures() {
    const Likeness alike = likeness(found_.signatures);
    result_.effect_names = alike.effects;
    result_.likeness = alike.cosine;
    result_.mimics = mimics(alike);
    result_.detectable = detectable(found_.signatures);
  }

  void add_posterior(const HypothesisFit& fit) {
    if (fit.draws.cols() == 0) return;
    MatrixXd values(fit.draws.rows(), fit.draws.cols());
    const Predictor& predict = problem_.predictors->of(fit.together);
    for (Index k = 0; k < values.cols(); ++k) values.col(k) = predict.values_of(fit.draws.col(k));
    result_.posteriors.emplace_back(name_of(fit), std::move(values));
  }

  // How probable a set is beside the first that is named.
  double beside_the_first(const JudgedFit& set) const {
    const Inclusion& inclusion = found_.inclusion;
    return std::exp(inclusion.log_weight(set) -
                    inclusion.log_weight(*found_.judgement.named.front()));
  }

  // What an effect at a place explains stands for the place.
  void add_components(const std::vector<EffectFits>& ranked) {
    std::map<std::string, double> most;
    for (const EffectFits& f : ranked) {
      const std::string& place = f.best->fit.together[0]->place;
      double& own = most[is_at_sensor(place) || is_at_cap(place) ? place : part_of_set(place)];
      own = std::max(own, f.best->log_bayes_factor);
    }
    for (const auto& [component, log_bayes] : most)
      if (log_bayes > 0) {
        LocatedGap gap;
        gap.component = component;
        gap.z = std::sqrt(2 * log_bayes);
        gap.significant = log_bayes > threshold::over_nothing;
        result_.where.push_back(gap);
      }
  }

  // Over the level: the test's, and the model's.
  void add_trends(const HypothesisFit& best) {
    result_.trends = level_trends(problem_.readings);
    TestReadings model = problem_.readings;
    for (std::size_t i = 0; i < model.readings.size(); ++i)
      model.readings[i].log_value = problem_.log_measured[Index(i)] - best.deviation[Index(i)];
    const std::vector<LevelTrend> of_model = level_trends(model);
    for (std::size_t i = 0; i < of_model.size(); ++i) result_.trends[i].best = of_model[i].slope;
  }

  // A law of slip is known over the levels that were fitted; what was held out beyond them it alone
  // foretells.
  void add_reach(const HypothesisFit& best) {
    const auto slips = std::find_if(best.together.begin(), best.together.end(),
                                    [](const Hypothesis* h) { return bool(h->softening); });
    if (slips == best.together.end()) return;
    struct Levels {
      double least = 1e300, most = 0, held_out = 0;
    };
    std::map<std::pair<Input, bool>, Levels> by_excitation;
    for (const Reading& r : problem_.readings.readings) {
      if (r.run < 0) continue;
      const TestRun& run = problem_.readings.runs[std::size_t(r.run)];
      if (!(run.level > 0)) continue;
      Levels& own = by_excitation[{run.input, run.by_force}];
      if (r.held_out) {
        own.held_out = std::max(own.held_out, run.level);
        continue;
      }
      own.least = std::min(own.least, run.level);
      own.most = std::max(own.most, run.level);
    }
    for (const auto& [excitation, own] : by_excitation)
      if (own.most > 0 && own.held_out > own.most) {
        const auto& [input, by_force] = excitation;
        const char* unit = by_force ? "N" : "m/s2";
        result_.warnings.push_back(fmt::format(
            "{} at {}: its law is fitted from {:.3g} to {:.3g} {}{}; at {:.3g} {}, which is held "
            "out, the law alone speaks",
            (*slips)->effect, (*slips)->place, own.least, own.most, unit,
            input.any() ? " (" + word_of(input) + ")" : "", own.held_out, unit));
      }
  }

  void how_far() {
    const HypothesisFit& nominal = found_.nominal.fit;
    const Told& told = found_.told;
    result_.gap = gap_shrink(found_.context, *problem_.fitted, nominal, told.best);
    if (!problem_.held_out->rows().empty()) {
      result_.held_out = gap_shrink(found_.context, *problem_.held_out, nominal, told.best);
      for (const std::string& h : problem_.test.data.hold_out)
        result_.held_out_how += (result_.held_out_how.empty() ? "" : ", ") + h;
      if (result_.held_out_how.empty())
        result_.held_out_how = "the highest level of each direction";
    } else if (told.in_turn) {
      result_.held_out = told.in_turn;
      result_.held_out_how = how_in_turn(found_.context.fitted.rows().size());
    }
    const MatrixXd total = problem_.uncertainty.total();
    for (std::size_t i = 0; i < problem_.readings.readings.size(); ++i) {
      const Reading& r = problem_.readings.readings[i];
      const auto value = [&](const HypothesisFit& fit) {
        return value_of(r, problem_.log_measured[Index(i)] - fit.deviation[Index(i)]);
      };
      ComparedReading row{.kind = r.kind,
                          .name = r.name,
                          .unit = r.unit,
                          .measured = r.value,
                          .nominal = value(nominal),
                          .best = value(told.best),
                          .second = {},
                          .sigma = std::sqrt(total(Index(i), Index(i))),
                          .held_out = r.held_out};
      if (told.second) row.second = value(*told.second);
      result_.readings.push_back(std::move(row));
    }
  }

  void add_resonator() {
    const std::optional<HypothesisFit>& fit = found_.told.resonator;
    if (!fit) return;
    const Judgement& judgement = found_.judgement;
    NamedEffect found = names_.last_of(*fit);
    result_.advice.push_back(fmt::format(
        "what may hang at {}: look there, and knock on it or measure on it; what hangs on a spring "
        "of its own shows its own resonance there",
        found.place));
    result_.resonator = {.found = std::move(found),
                         .words = words_of_last(judgement.resonator->fit),
                         .gap_after = judgement.resonator->gap_after,
                         .is_ahead = judgement.resonator_is_ahead(found_.nominal)};
  }

  // Beside effects that were tried: what the case has no place for is not told apart from anything.
  void advise(const Judgement& judgement) {
    const auto tried = [&](const std::string& effect) {
      return std::any_of(problem_.hypotheses.begin(), problem_.hypotheses.end(),
                         [&](const Hypothesis& h) { return h.effect == effect; });
    };
    const auto given = [&](const std::string& advice) {
      return std::find(result_.advice.begin(), result_.advice.end(), advice) !=
             result_.advice.end();
    };
    const bool all_weighed = is_weighed_in_all_states(problem_.test.data);
    for (const JudgedFit* j : judgement.named)
      for (const Hypothesis* h : j->fit.together)
        for (const auto& [other, how, by_scale] : effect_named(h->effect).look_alikes) {
          const std::string advice = h->effect + " or " + other + ": " + how;
          if (by_scale && all_weighed) continue;
          if (tried(other) && !given(advice) && !given(other + " or " + h->effect + ": " + how))
            result_.advice.push_back(advice);
        }
  }

  GapProblem& problem_; // its predictors are made as they are asked for
  const Findings& found_;
  const DiagnosisSettings& settings_;
  const NamedEffects names_;
  Diagnosis result_;
};

} // namespace

Diagnosis account_of(GapProblem& problem, const Findings& found,
                     const DiagnosisSettings& settings) {
  return Account(problem, found, settings).diagnosis();
}

} // namespace plica

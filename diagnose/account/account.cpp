#include "diagnose/account/account.hpp"

#include "diagnose/account/assumptions.hpp"
#include "diagnose/account/ledger.hpp"
#include "diagnose/account/named_effects.hpp"
#include "diagnose/account/next_measurement.hpp"
#include "diagnose/account/overlays.hpp"
#include "diagnose/account/residual_energy.hpp"
#include "diagnose/account/shrink.hpp"
#include "diagnose/account/tried.hpp"
#include "diagnose/judge/headline.hpp"
#include "diagnose/judge/thresholds.hpp"
#include "lab/measured/measured_words.hpp"

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
    const FitContext& context = found_.context;
    const JudgedFit& nominal = found_.nominal;
    const std::vector<EffectFits>& ranked = found_.ranked;
    const Judgement& judgement = found_.judgement;
    result_.case_name = problem_.data.name;
    result_.verdict = judgement.verdict;
    result_.probabilities = judgement.probabilities;
    settings_.stage("ledger", 0.90);
    const std::vector<HypothesisFit> told = fits_told();
    std::vector<std::vector<NamedEffect>> members;
    for (const HypothesisFit& fit : told) members.push_back(names_.members_of(fit));
    keep_ledger(told, members);
    add_effects(members);
    settings_.stage("report", 0.94);
    result_.where = located(found_.scores, nominal.fit.deviation);
    for (LocatedGap& gap : residual_energy(problem_.nominal, problem_.readings, problem_.test.data))
      result_.where.push_back(std::move(gap));
    add_components(ranked);
    const JudgedFit* first = best_of(nominal, judgement);
    Tried all = tried(problem_, found_, names_, *first);
    result_.tried = std::move(all.all);
    result_.best = all.best;
    for (const EffectFits& f : ranked) result_.evaluations += f.best->fit.evaluations;
    const JudgedFit* other = second_of(ranked, first);
    std::vector<HypothesisFit> shown{told.empty() ? first->fit : told.front()};
    if (other) shown.push_back(other->fit);
    for (HypothesisFit& fit : shown) complete(context, fit);
    const HypothesisFit& best = shown.front();
    const HypothesisFit* second = other ? &shown.back() : nullptr;
    how_far(context, nominal, best, second);
    add_trends(best);
    result_.basis_error = problem_.predictors->of(best.together).basis_error(best.values);
    if (best.together.size() == 1) result_.drifts = drifts(context, best);
    result_.compensators = found_.compensators;
    add_signatures();
    result_.overlays = overlays_of(problem_, best, second);
    for (const HypothesisFit& fit : shown) add_posterior(fit);
    plan_next(nominal);
    advise(judgement);
    result_.assumptions = assumptions_of(problem_, found_.standards, settings_.without);
    result_.warnings = problem_.readings.warnings;
    add_reach(best);
    result_.baseline = problem_.baseline;
    result_.hypotheses = int(problem_.hypotheses.size());
    result_.headline = headline(nominal, judgement);
    keep_picture();
    return std::move(result_);
  }

private:
  void keep_picture() {
    const Model& model = problem_.nominal.structure(problem_.test.data).built.model;
    result_.mesh = model.mesh;
    for (const BeamElement& b : model.beams) result_.lines.push_back({b.node1, b.node2});
  }

  // What the user is told of: the effects named, else what comes nearest. Where several act at
  // once, or errors are larger than stated, with draws of all their parameters together.
  std::vector<HypothesisFit> fits_told() const {
    const Judgement& judgement = found_.judgement;
    if (judgement.sampled) return {*judgement.sampled};
    std::vector<const JudgedFit*> chosen = judgement.named;
    if (chosen.empty() && judgement.nearest) chosen.push_back(judgement.nearest);
    std::vector<HypothesisFit> told;
    for (const JudgedFit* j : chosen) told.push_back(j->fit);
    if (judgement.names_sets() || judgement.verdict == Verdict::mostly ||
        judgement.verdict == Verdict::unknown)
      for (HypothesisFit& fit : told)
        sample(found_.context, fit, settings_.particles, 1, dispersion(fit));
    return told;
  }

  // An ambiguous list is one row: each of it would explain that much. Of sets that explain the test
  // alike the rows are those of the first, each with what takes its place in the others, and draws
  // of all of them; of what leads draws beside further effects, too.
  void keep_ledger(const std::vector<HypothesisFit>& told,
                   const std::vector<std::vector<NamedEffect>>& members) {
    const Judgement& judgement = found_.judgement;
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
    for (LedgerSet& set :
         sets_beside(*best_of(found_.nominal, judgement), found_.beside, found_.inclusion))
      sets.push_back(std::move(set));
    const bool settled =
        sets.empty() || (judgement.verdict != Verdict::unknown && judgement.withheld.empty());
    result_.ledger = ledger_of(found_.context, found_.nominal.fit, sets,
                               settled ? 0 : weight_of_something_else(told, sets));
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

  // Each once, wherever sets that are named share it.
  void add_effects(const std::vector<std::vector<NamedEffect>>& members) {
    for (std::size_t i = 0; i < found_.judgement.named.size(); ++i)
      for (const NamedEffect& e : members[i])
        if (std::none_of(result_.effects.begin(), result_.effects.end(),
                         [&](const NamedEffect& own) { return is_same(own, e); }))
          result_.effects.push_back(e);
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
      const std::string component = place.substr(0, place.find('.'));
      most[component == "sensor" ? place : component] =
          std::max(most[component == "sensor" ? place : component], f.best->log_bayes_factor);
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

  static const JudgedFit* best_of(const JudgedFit& nominal, const Judgement& judgement) {
    if (!judgement.named.empty()) return judgement.named.front();
    return judgement.nearest ? judgement.nearest : &nominal;
  }
  static const JudgedFit* second_of(const std::vector<EffectFits>& ranked, const JudgedFit* best) {
    for (const EffectFits& f : ranked)
      if (f.best != best) return f.best;
    return nullptr;
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

  void how_far(const FitContext& context, const JudgedFit& nominal, const HypothesisFit& best,
               const HypothesisFit* second) {
    const Judgement& judgement = found_.judgement;
    result_.gap = gap_shrink(context, *problem_.fitted, nominal.fit, best);
    if (!problem_.held_out->rows().empty()) {
      result_.held_out = gap_shrink(context, *problem_.held_out, nominal.fit, best);
      for (const std::string& h : problem_.test.data.hold_out)
        result_.held_out_how += (result_.held_out_how.empty() ? "" : ", ") + h;
      if (result_.held_out_how.empty())
        result_.held_out_how = "the highest level of each direction";
    } else if (problem_.fitted->rows().size() > 2 && !best.together.empty()) {
      const bool leads = !judgement.named.empty() && judgement.named.front()->fit.z == best.z &&
                         judgement.named.front()->fit.together == best.together;
      result_.held_out =
          leads && judgement.in_turn ? *judgement.in_turn : in_turn(context, nominal.fit, best);
      result_.held_out_how = how_in_turn(context.fitted.rows().size());
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
                          .nominal = value(nominal.fit),
                          .best = value(best),
                          .second = {},
                          .sigma = std::sqrt(total(Index(i), Index(i))),
                          .held_out = r.held_out};
      if (second) row.second = value(*second);
      result_.readings.push_back(std::move(row));
    }
  }

  // Among what the test leaves open: the nominal case, sets of effects, their numbers.
  void plan_next(const JudgedFit& nominal) {
    if (!settings_.plan_next || settings_.stop()) return;
    settings_.stage("next measurement", 0.98);
    constexpr std::size_t most = 5;
    constexpr double never_ruled_out = 0.02, ruled_out = 1e-3;
    std::vector<RivalSet> rivals;
    const auto add = [&](const JudgedFit& j, double probability) {
      if (j.adequate) probability = std::max(probability, never_ruled_out);
      if (probability < ruled_out) return;
      rivals.push_back({.together = j.fit.together,
                        .values = j.fit.values,
                        .probability = probability,
                        .draws = {}});
      const int count = j.fit.together.size() > 2 ? 6 : 12; // every subset of a draw is solved
      rivals.back().draws = share_draws(found_.context, nominal.fit, j.fit, count);
    };
    if (nominal.adequate) add(nominal, found_.inclusion.none());
    for (const auto& [fit, probability] : found_.inclusion.first(most)) add(*fit, probability);
    result_.next = next_measurements(problem_.data, problem_.nominal, problem_.test.data,
                                     problem_.readings, rivals, problem_.predictors->models());
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
    for (const JudgedFit* j : judgement.named)
      for (const Hypothesis* h : j->fit.together)
        for (const auto& [other, how] : effect_named(h->effect).look_alikes) {
          const std::string advice = h->effect + " or " + other + ": " + how;
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

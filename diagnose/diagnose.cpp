#include "diagnose/diagnose.hpp"

#include "diagnose/account/account.hpp"
#include "diagnose/account/next_measurement.hpp"
#include "diagnose/account/shrink.hpp"
#include "diagnose/account/told_apart.hpp"
#include "diagnose/judge/added_up.hpp"
#include "diagnose/judge/inclusion.hpp"
#include "diagnose/judge/judge.hpp"
#include "diagnose/judge/matched_gain.hpp"
#include "diagnose/judge/places_fitted.hpp"
#include "diagnose/judge/sets.hpp"
#include "diagnose/judge/thresholds.hpp"
#include "diagnose/objections.hpp"
#include "diagnose/results/stage_share.hpp"
#include "diagnose/weigh/baseline.hpp"
#include "solve/parallel.hpp"
#include "solve/stopwatch.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t confirmed = 3; // hypotheses followed by Markov chains

class Stages {
public:
  Stages(const Case& data, const TestData& test, const DiagnosisSettings& settings)
      : stated_(stated_gap(data, test, settings)), problem_(*stated_), settings_(settings) {}

  Diagnosis diagnosis() {
    const FitContext context = problem_.context();
    const BlockScores scores(problem_.readings, problem_.uncertainty);
    settings_.stage(
        fmt::format("signatures of {} hypotheses", looked_at(problem_.hypotheses).size()),
        share::bases);
    std::vector<Signature> all = signatures_of_all(context);
    find_smallest(context, all);
    Standards standards = standards_of(context, *problem_.held_out, scores);
    standards.gate = !settings_.without.contains(Guard::adequacy);
    standards.evidence = evidence_threshold(context, all);

    settings_.search();
    settings_.stage("fits", share::fits);
    const HypothesisFit plain = nominal_fit(context);
    const JudgedFit nominal = judged(plain, plain, context, *problem_.held_out, scores, standards);
    auto [fits, passed_over] = fit_all(context, all, plain, scores, standards);
    drop_places_with_a_cause(fits, nominal);
    std::vector<EffectFits> ranked = fits_by_effect(fits, passed_over);
    confirm(context, ranked, fits, plain, scores, standards);
    ranked = fits_by_effect(fits, passed_over);
    return concluded({.context = context,
                      .ranked = ranked,
                      .fits = fits,
                      .passed_over = passed_over,
                      .all = all,
                      .nominal = nominal,
                      .held_out = *problem_.held_out,
                      .scores = scores,
                      .standards = standards,
                      .settings = settings_},
                     plain);
  }

private:
  std::vector<Signature> signatures_of_all(const FitContext& context) const {
    const std::vector<Hypothesis>& all = problem_.hypotheses;
    const std::size_t states = problem_.predictors->models()->fitted_states(context.test).size();
    const std::vector<const Hypothesis*> first = looked_at(all);
    StageShare reduced(settings_, share::bases, share::signatures, states * first.size());
    reduce_each(context, first, [&] { reduced.one_is_done(); });
    StageShare behind(settings_, share::signatures, share::fits, first.size());
    return signatures(context, all, [&] { behind.one_is_done(); });
  }

  // Single effects are known: sets of them, the verdict and its account.
  Diagnosis concluded(const SetSearch& search, const HypothesisFit& plain) {
    const FitContext& context = search.context;
    const std::vector<JudgedFit> sets = sets_of(search, plain);
    const Inclusion inclusion(search.nominal, search.fits, sets, search.passed_over);
    const std::vector<Compensator> tempting = compensators(
        context, search.held_out, plain, problem_.nominal.structure(problem_.test.data));
    Objections objections(
        problem_, search, plain, tempting, [&] { return resonators_of(problem_); }, inclusion);
    const Judgement judgement = judgement_of(search, plain, sets, inclusion, objections);
    std::vector<JudgedFit> beside;
    if (judgement.verdict != Verdict::ambiguous) {
      beside = objections.beside();
      if (beside.empty() && !judgement.named.empty())
        beside = fit_beside(search, *judgement.named.front());
    }
    settings_.stage("ledger", share::ledger);
    const Told told =
        told_of(problem_, search.nominal, search.ranked, judgement, settings_.particles);
    const Findings found{.context = context,
                         .scores = search.scores,
                         .standards = search.standards,
                         .nominal = search.nominal,
                         .ranked = search.ranked,
                         .fits = search.fits,
                         .sets = sets,
                         .beside = beside,
                         .inclusion = inclusion,
                         .judgement = judgement,
                         .told = told,
                         .signatures = search.all,
                         .compensators = tempting};
    Diagnosis result = account_of(problem_, found, settings_);
    if (settings_.plan_next && !settings_.stop()) {
      settings_.stage("next measurement", share::next_measurement);
      const OfferedReadings menu =
          offered_beside(problem_.data, problem_.nominal, problem_.test.data, problem_.readings,
                         problem_.predictors->models());
      result.next = next_after(found, menu);
      warn(result, say_what_tells_apart(problem_, menu, told.fits, result.ledger));
    }
    if (told.first->fit.together.size() > 1 && !judgement.stopped)
      warn(result, warning_of_added_up(sets));
    if (judgement.stopped)
      result.warnings.insert(result.warnings.begin(),
                             "stopped before all effects were tried: this is what came nearest");
    result.not_tried = problem_.not_tried;
    result.seconds = watch_.seconds();
    return result;
  }

  static void warn(Diagnosis& result, std::string warning) {
    if (!warning.empty()) result.warnings.push_back(std::move(warning));
  }

  // With what the user is warned of beside it.
  Judgement judgement_of(const SetSearch& search, const HypothesisFit& plain,
                         const std::vector<JudgedFit>& sets, const Inclusion& inclusion,
                         Objections& objections) {
    // Before all was tried nothing is known to be the best.
    if (settings_.stop()) return nearest_so_far(search.nominal, inclusion);
    Referee referee = objections.referee();
    referee.mounted_anew = mounted_anew(search.context, plain, search.standards);
    Judgement judgement =
        judge(search.nominal, search.ranked, sets, inclusion, search.standards, referee);
    std::vector<std::string>& warnings = problem_.readings.warnings;
    if (!judgement.warning.empty()) warnings.push_back(judgement.warning);
    if (!judgement.resonator) judgement.resonator = objections.resonator_beyond(judgement);
    if (judgement.mounted_anew)
      warnings.push_back(ask_for_a_baseline());
    else if (judgement.verdict == Verdict::none)
      ask_for_remounting(search.context, plain, search.standards);
    return judgement;
  }

  // Of one of several that an answer lists: of effect and place; of sets each alike.
  static double probability_in(const Judgement& answer, const JudgedFit& one) {
    if (answer.names_sets()) return 1 / double(answer.named.size());
    const Hypothesis& h = *one.fit.together.front();
    return answer.probability_of(h.effect) * answer.share_of(h.effect, h.place);
  }

  // What would tell apart what an answer lists; else what the test leaves open: the nominal case,
  // sets of effects, their numbers.
  std::vector<ProposedMeasurement> next_after(const Findings& found,
                                              const OfferedReadings& menu) const {
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
      rivals.back().draws = share_draws(found.context, found.nominal.fit, j.fit, count);
    };
    const Judgement& answer = found.judgement;
    if (answer.verdict == Verdict::ambiguous && answer.named.size() > 1) {
      for (const JudgedFit* j : answer.named) add(*j, probability_in(answer, *j));
      return next_measurements(problem_.nominal, menu, rivals, problem_.predictors->models());
    }
    if (found.nominal.adequate) add(found.nominal, found.inclusion.none());
    for (const auto& [fit, probability] : found.inclusion.first(most)) add(*fit, probability);
    return next_measurements(problem_.nominal, menu, rivals, problem_.predictors->models());
  }

  std::vector<JudgedFit> sets_of(const SetSearch& search, const HypothesisFit& plain) const {
    if (search.nominal.adequate || !wants_several(search.ranked, search.all, search.standards))
      return {};
    std::vector<JudgedFit> sets = fit_sets(search);
    if (search.held_out.rows().empty()) take_in_turn(search.context, plain, sets);
    return sets;
  }

  // No single effect explains the test; or what one that does leaves asks for more; or with a
  // second one another, which alone does not, would come as near as the best. Beside a baseline the
  // latter two may be what the change does not do exactly.
  bool wants_several(const std::vector<EffectFits>& ranked, const std::vector<Signature>& all,
                     const Standards& standards) const {
    const auto explains = [](const EffectFits& f) { return f.best->credible(); };
    const auto best = std::find_if(ranked.begin(), ranked.end(), explains);
    if (best == ranked.end()) return true;
    if (!problem_.baseline.readings.empty()) return false;
    return std::any_of(ranked.begin(), ranked.end(), [&](const EffectFits& f) {
      const double behind = best->log_evidence - f.log_evidence;
      if (f.best->stands())
        return behind < standards.apart &&
               worth_of_one_more(f.best->fit, all) >= threshold::beyond_chance;
      return !f.best->adequate && behind < threshold::within_reach &&
             behind < worth_of_one_more(f.best->fit, all) + threshold::alike;
    });
  }

  // Whether the change is more than this scatter of mounting anew leaves open.
  bool exceeds(double remounting, const FitContext& context, const HypothesisFit& plain,
               const Standards& standards) const {
    const double ratio = remounting / problem_.remounting.frequency;
    const MatrixXd further = (ratio * ratio - 1) * problem_.uncertainty.reassembly;
    return context.fitted.widened(further)(plain.deviation).squaredNorm() > standards.chi2;
  }

  // Beside a baseline, and neither stated nor well known from several.
  bool remounting_is_supposed() const {
    return !problem_.baseline.readings.empty() &&
           most_of(problem_.remounting) > problem_.remounting.frequency;
  }

  // What was not mounted anew may have changed by less than what mounting anew covers.
  void ask_for_remounting(const FitContext& context, const HypothesisFit& plain,
                          const Standards& standards) {
    constexpr double untouched = 0.001; // drift of a frequency from one day to the next
    if (!remounting_is_supposed() || !exceeds(untouched, context, plain, standards)) return;
    problem_.readings.warnings.push_back(fmt::format(
        "the change lies within what mounting anew usually makes ({:.2g} %), but beyond {:.2g} %: "
        "if the specimen stayed as it was mounted, state remounting: {:.2g} % in diagnose",
        100 * problem_.remounting.frequency, 100 * untouched, 100 * untouched));
  }

  // Whether mounting anew alone may have made the change, by as much as one baseline or few leave
  // open.
  bool mounted_anew(const FitContext& context, const HypothesisFit& plain,
                    const Standards& standards) const {
    return remounting_is_supposed() &&
           !exceeds(most_of(problem_.remounting), context, plain, standards);
  }

  std::string ask_for_a_baseline() const {
    return fmt::format(
        "the change is larger than mounting anew usually makes it ({:.2g} %), but no effect "
        "comes near it and one baseline cannot exclude {:.2g} %: measure the baseline once more, "
        "mounted anew, or state remounting",
        100 * problem_.remounting.frequency, 100 * most_of(problem_.remounting));
  }

  PlacesFitted fit_all(const FitContext& context, const std::vector<Signature>& all,
                       const HypothesisFit& plain, const BlockScores& scores,
                       const Standards& standards) {
    std::vector<const Hypothesis*> heard;
    for (const Signature& s : all)
      if (s.g.norm() >= silent || !s.hypothesis->between.empty()) heard.push_back(s.hypothesis);
    StageShare behind(settings_, share::fits, share::chains, heard.size());
    return fit_places(context, heard, [&](const Hypothesis& h) {
      if (settings_.stop()) return JudgedFit();
      JudgedFit own =
          judged(fit_of(context, {&h}), plain, context, *problem_.held_out, scores, standards);
      behind.one_is_done();
      return own;
    });
  }

  // The best hypotheses of the best effects once more by Markov chains; what speaks for its effect
  // is held against what was held out, too.
  void confirm(const FitContext& context, const std::vector<EffectFits>& ranked,
               std::vector<JudgedFit>& fits, const HypothesisFit& plain, const BlockScores& scores,
               const Standards& standards) {
    if (settings_.stop()) return;
    settings_.stage("Markov chains", share::chains);
    std::vector<JudgedFit*> chosen;
    for (const EffectFits& f : ranked)
      if (f.log_evidence > plain.log_evidence - 1)
        for (JudgedFit& j : fits)
          if (&j == f.best) chosen.push_back(&j);
    for (std::size_t i = 0; i < std::min(confirmed, chosen.size()); ++i)
      sample(context, chosen[i]->fit, settings_.particles, unsigned(i) + 1);
    in_parallel(int(chosen.size()), [&](int i) {
      HypothesisFit fit = chosen[std::size_t(i)]->fit;
      complete(context, fit);
      *chosen[std::size_t(i)] =
          judged(std::move(fit), plain, context, *problem_.held_out, scores, standards);
    });
  }

  // Where nothing is held out, readings taken in turn speak for the best of the sets.
  void take_in_turn(const FitContext& context, const HypothesisFit& plain,
                    std::vector<JudgedFit>& sets) const {
    constexpr std::size_t most = 3;
    std::vector<JudgedFit*> best;
    for (JudgedFit& set : sets)
      if (set.credible()) best.push_back(&set);
    std::stable_sort(best.begin(), best.end(), [](const JudgedFit* a, const JudgedFit* b) {
      return a->fit.log_evidence > b->fit.log_evidence;
    });
    for (std::size_t i = 0; i < std::min(most, best.size()); ++i) {
      const GapShrink turn = in_turn(context, plain, best[i]->fit);
      best[i]->held_out_shrink = turn.shrink();
      best[i]->held_out_met = turn.is_sure();
    }
  }

  Stopwatch watch_;
  std::unique_ptr<GapProblem> stated_;
  GapProblem& problem_;
  const DiagnosisSettings& settings_;
};

} // namespace

Diagnosis diagnose(const Case& data, const TestData& test, const DiagnosisSettings& settings) {
  return Stages(data, test, settings).diagnosis();
}

} // namespace plica

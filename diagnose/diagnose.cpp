#include "diagnose/diagnose.hpp"

#include "diagnose/account/account.hpp"
#include "diagnose/account/shrink.hpp"
#include "diagnose/effects/chosen_effects.hpp"
#include "diagnose/effects/growth.hpp"
#include "diagnose/judge/judge.hpp"
#include "diagnose/judge/pairs.hpp"
#include "diagnose/weigh/baseline.hpp"
#include "diagnose/weigh/scatter.hpp"
#include "lab/measured/states.hpp"
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

constexpr double silent = 0.3;       // |g| below which no data speak of an effect
constexpr std::size_t confirmed = 3; // hypotheses followed by Markov chains

// Readings that the model answers; what it does not is said.
TestReadings answered(const Nominal& nominal, TestReadings test) {
  const auto y = Predictor(nominal, test, {})(VectorXd());
  if (!y) throw std::runtime_error("the nominal structure has no stable answer");
  std::vector<Reading> kept;
  for (std::size_t i = 0; i < test.readings.size(); ++i) {
    if (std::isfinite((*y)[Index(i)]))
      kept.push_back(test.readings[i]);
    else
      test.warnings.push_back("the model gives no " + test.readings[i].name + " (" +
                              test.readings[i].entry + ")");
  }
  test.readings = std::move(kept);
  if (test.readings.empty())
    throw std::invalid_argument("the model gives none of the measured quantities");
  return test;
}

// Runs above the lowest level of their direction go.
void lowest_levels_only(TestReadings& test) {
  std::map<int, double> lowest;
  for (const TestRun& run : test.runs) {
    const auto [at, made] = lowest.try_emplace(run.base, run.level);
    if (!made) at->second = std::min(at->second, run.level);
  }
  std::erase_if(test.readings, [&](const Reading& r) {
    if (r.run < 0) return false;
    const TestRun& run = test.runs[std::size_t(r.run)];
    return run.level > lowest.at(run.base);
  });
}

class Stages {
public:
  Stages(const Case& data, const DiagnosisData& test, const DiagnosisSettings& settings)
      : problem_{.data = data, .test = test}, settings_(settings) {}

  Diagnosis diagnosis() {
    settings_.stage("nominal case");
    problem_.nominal = nominal_of(problem_.data, problem_.test.data);
    problem_.readings = readings_of(problem_.test);
    if (std::all_of(problem_.readings.readings.begin(), problem_.readings.readings.end(),
                    [&](const Reading& r) { return is_baseline(problem_.test.data, r.state); }))
      throw std::invalid_argument("nothing was measured but in baselines");
    if (settings_.without.contains("levels")) lowest_levels_only(problem_.readings);
    if (settings_.without.contains("heldout"))
      for (Reading& r : problem_.readings.readings) r.held_out = false;
    const Measured& measured = problem_.test.data;
    pair_like_baselines(problem_.nominal, measured, problem_.readings);
    problem_.readings = answered(problem_.nominal, std::move(problem_.readings));
    settings_.stage("admissible specimens");
    problem_.remounting = remounting_of(problem_.readings, measured, problem_.data.diagnose);
    problem_.uncertainty = uncertainty_of(problem_.data, problem_.nominal, problem_.readings,
                                          measured, settings_.without, problem_.remounting);
    problem_.baseline =
        given_baselines(measured, problem_.data.diagnose, problem_.readings, problem_.uncertainty);
    if (problem_.readings.readings.empty())
      throw std::invalid_argument("the model gives none of what was measured after the baseline");
    problem_.log_measured.resize(Index(problem_.readings.readings.size()));
    for (Index i = 0; i < problem_.log_measured.size(); ++i)
      problem_.log_measured[i] = problem_.readings.readings[std::size_t(i)].log_value;
    problem_.fitted.emplace(problem_.readings, problem_.uncertainty, false);
    problem_.held_out.emplace(problem_.readings, problem_.uncertainty, true);
    if (problem_.fitted->rows().empty())
      throw std::invalid_argument("all that was measured is held out");
    problem_.predictors.emplace(problem_.nominal, problem_.readings);
    const FitContext context{*problem_.predictors, problem_.readings, problem_.uncertainty,
                             problem_.log_measured, *problem_.fitted};
    const BlockScores scores(problem_.readings, problem_.uncertainty);
    list_hypotheses();
    settings_.stage("signatures of " + std::to_string(problem_.hypotheses.size()) + " hypotheses");
    std::vector<Signature> all = signatures(context, problem_.hypotheses);
    find_smallest(context, all);
    Standards standards = standards_of(context, *problem_.held_out, scores);
    standards.gate = !settings_.without.contains("adequacy");
    standards.evidence = evidence_threshold(context, all);
    constexpr double apart_beside_errors = 5; // nats: a model that errs makes some of its own
    if (problem_.uncertainty.change_error > 0) standards.apart = apart_beside_errors;

    settings_.stage("fits");
    const HypothesisFit plain = nominal_fit(context);
    const JudgedFit nominal = judged(plain, plain, context, *problem_.held_out, scores, standards);
    std::vector<JudgedFit> fits = fit_all(context, all, plain, scores, standards);
    std::vector<Family> ranked = families(fits);
    confirm(context, ranked, fits, plain, scores, standards);
    ranked = families(fits);
    std::vector<JudgedFit> pairs;
    if (!nominal.adequate && std::none_of(ranked.begin(), ranked.end(),
                                          [](const Family& f) { return f.best->credible(); })) {
      settings_.stage("pairs of effects");
      pairs = fit_pairs(context, ranked, fits, all, plain, *problem_.held_out, scores, standards);
      if (problem_.held_out->rows().empty()) take_in_turn(context, plain, pairs);
    }
    const std::vector<Compensator> tempting = compensators(
        context, *problem_.held_out, plain, problem_.nominal.structure(problem_.test.data));
    const Judgement judgement = judge(nominal, ranked, pairs, standards, [&](const JudgedFit& j) {
      return objection(context, plain, tempting, j);
    });
    settings_.stage("report");
    Diagnosis result = account_of(problem_,
                                  {.context = context,
                                   .scores = scores,
                                   .standards = standards,
                                   .nominal = nominal,
                                   .ranked = ranked,
                                   .fits = fits,
                                   .pairs = pairs,
                                   .judgement = judgement,
                                   .signatures = all,
                                   .compensators = tempting},
                                  settings_);
    result.not_tried = std::move(not_tried_);
    result.seconds = watch_.seconds();
    return result;
  }

private:
  void list_hypotheses() {
    ChosenEffects chosen = chosen_effects(problem_.nominal.structure(problem_.test.data));
    for (const std::string& name : chosen.without_place)
      not_tried_.push_back({name, effect_named(name).needs});
    const std::vector<std::string> states = changed_states(problem_.test.data);
    for (Hypothesis& h : chosen.hypotheses)
      problem_.hypotheses.push_back(grown(std::move(h), states));
    problem_.words = settings_.words;
    problem_.words.insert(problem_.words.end(), chosen.words.begin(), chosen.words.end());
  }

  std::vector<JudgedFit> fit_all(const FitContext& context, const std::vector<Signature>& all,
                                 const HypothesisFit& plain, const BlockScores& scores,
                                 const Standards& standards) {
    std::vector<JudgedFit> fits(all.size());
    in_parallel(int(all.size()), [&](int i) {
      const Signature& s = all[std::size_t(i)];
      if (s.g.norm() < silent) return;
      fits[std::size_t(i)] = judged(fit_of(context, {s.hypothesis}), plain, context,
                                    *problem_.held_out, scores, standards);
    });
    std::erase_if(fits, [](const JudgedFit& j) { return !j.fit.solved; });
    return fits;
  }

  // The best hypotheses of the best effects once more by Markov chains; what speaks for its effect
  // is held against what was held out, too.
  void confirm(const FitContext& context, const std::vector<Family>& ranked,
               std::vector<JudgedFit>& fits, const HypothesisFit& plain, const BlockScores& scores,
               const Standards& standards) {
    settings_.stage("Markov chains");
    std::vector<JudgedFit*> chosen;
    for (const Family& f : ranked)
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

  // Where nothing is held out, readings taken in turn speak for the best of the pairs.
  void take_in_turn(const FitContext& context, const HypothesisFit& plain,
                    std::vector<JudgedFit>& pairs) const {
    if (!can_be_taken_in_turn(context)) return;
    constexpr std::size_t most = 3;
    std::vector<JudgedFit*> best;
    for (JudgedFit& pair : pairs)
      if (pair.fit.solved && pair.credible()) best.push_back(&pair);
    std::stable_sort(best.begin(), best.end(), [](const JudgedFit* a, const JudgedFit* b) {
      return a->fit.log_evidence > b->fit.log_evidence;
    });
    for (std::size_t i = 0; i < std::min(most, best.size()); ++i) {
      const GapShrink turn = in_turn(context, plain, best[i]->fit);
      best[i]->held_out_shrink = turn.shrink();
      best[i]->held_out_met = turn.interval[0] > 0;
    }
  }

  static bool can_be_taken_in_turn(const FitContext& context) {
    constexpr std::size_t most = 24; // each is fitted anew
    return context.fitted.rows().size() <= most;
  }

  // Why what leads is not identified.
  Objection objection(const FitContext& context, const HypothesisFit& plain,
                      const std::vector<Compensator>& tempting, const JudgedFit& leads) {
    const std::size_t readings = context.fitted.rows().size();
    if (leads.free_parameters >= int(readings))
      return {fmt::format("{} free parameters for {} fitted readings", leads.free_parameters,
                          readings)};
    if (std::string rest = what_remains(plain, tempting, leads); !rest.empty())
      return {std::move(rest)};
    constexpr std::size_t fewest = 4;
    if (!problem_.held_out->rows().empty() || !can_be_taken_in_turn(context)) return {};
    const GapShrink turn = in_turn(context, plain, leads.fit);
    if (turn.interval[0] > 0) return {"", turn};
    const std::string found =
        fmt::format("taken in turn, readings are foretold no better with it (shrink {:.0f} % "
                    "[{:.0f}, {:.0f}])",
                    100 * turn.shrink(), 100 * turn.interval[0], 100 * turn.interval[1]);
    if (readings >= fewest) return {found, turn};
    problem_.readings.warnings.push_back(name_of(leads.fit) + ": " + found);
    return {"", turn};
  }

  // Effects that are such a factor themselves.
  static bool is_like(const Compensator& c, const Hypothesis& h) {
    return (h.effect == "damping" && c.name == "all damping") ||
           (h.effect == "temperature" && c.name == "Young's modulus");
  }

  // Beside a baseline an effect may be off by what it changes, so that much may remain of the gap.
  std::string what_remains(const HypothesisFit& plain, const std::vector<Compensator>& tempting,
                           const JudgedFit& leads) const {
    constexpr double within = 1.5, most_left = 0.3, as_well = 1.2;
    const double before = std::sqrt(plain.chi2 / double(plain.error.size()));
    if (problem_.baseline.readings.empty()) return "";
    for (const Compensator& c : tempting)
      if (c.gap_after < as_well * leads.gap_after && !is_like(c, *leads.fit.together[0]))
        return fmt::format(
            "{} times {:.3g} would leave no more of the change ({:.2g}, {:.2g} with it)", c.name,
            c.factor, c.gap_after, leads.gap_after);
    if (leads.gap_after < within) return "";
    if (leads.gap_after < most_left * before) return "";
    return fmt::format("it leaves {:.0f} % of the change", 100 * leads.gap_after / before);
  }

  GapProblem problem_;
  const DiagnosisSettings& settings_;
  Stopwatch watch_;
  std::vector<EffectNotTried> not_tried_;
};

} // namespace

Diagnosis diagnose(const Case& data, const DiagnosisData& test, const DiagnosisSettings& settings) {
  return Stages(data, test, settings).diagnosis();
}

} // namespace plica

#include "diagnose/diagnose.hpp"

#include "diagnose/judge/headline.hpp"
#include "diagnose/judge/identifiability.hpp"
#include "diagnose/weigh/interval.hpp"
#include "diagnose/judge/judge.hpp"
#include "diagnose/account/next_measurement.hpp"
#include "diagnose/judge/pairs.hpp"
#include "diagnose/account/residual_energy.hpp"
#include "diagnose/weigh/scatter.hpp"
#include "diagnose/account/shrink.hpp"
#include "solve/parallel.hpp"
#include "solve/stopwatch.hpp"

#include <algorithm>
#include <cmath>
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

class Work {
public:
  Work(const Case& data, const DiagnosisData& data_of_test, const DiagnosisSettings& settings)
      : case_(data), measured_(data_of_test.data), responses_(data_of_test), settings_(settings) {}

  Diagnosis diagnosis() {
    settings_.stage("nominal case");
    nominal_ = nominal_of(case_, measured_);
    test_ = readings_of(responses_);
    if (settings_.without.contains("levels")) lowest_levels_only(test_);
    if (settings_.without.contains("heldout"))
      for (Reading& r : test_.readings) r.held_out = false;
    test_ = answered(nominal_, std::move(test_));
    settings_.stage("admissible specimens");
    uncertainty_ = uncertainty_of(case_, nominal_, test_, measured_, settings_.without);
    log_measured_.resize(Index(test_.readings.size()));
    for (Index i = 0; i < log_measured_.size(); ++i)
      log_measured_[i] = test_.readings[std::size_t(i)].log_value;
    fitted_.emplace(test_, uncertainty_, false);
    held_out_.emplace(test_, uncertainty_, true);
    if (fitted_->rows().empty()) throw std::invalid_argument("all that was measured is held out");
    predictors_.emplace(nominal_, test_);
    const FitContext context{*predictors_, test_, uncertainty_, log_measured_, *fitted_};
    const BlockScores scores(test_, uncertainty_);
    list_hypotheses();
    settings_.stage("signatures of " + std::to_string(hypotheses_.size()) + " hypotheses");
    std::vector<Signature> all = signatures(context, hypotheses_);
    find_smallest(context, all);
    Standards standards = standards_of(context, *held_out_, scores);
    standards.gate = !settings_.without.contains("adequacy");
    standards.evidence = evidence_threshold(context, all);

    settings_.stage("fits");
    const HypothesisFit plain = nominal_fit(context);
    const JudgedFit nominal = judged(plain, plain, context, *held_out_, scores, standards);
    std::vector<JudgedFit> fits = fit_all(context, all, plain, scores, standards);
    std::vector<Family> ranked = families(fits);
    confirm(context, ranked, fits, plain, scores, standards);
    ranked = families(fits);
    std::vector<JudgedFit> pairs;
    if (!nominal.adequate && std::none_of(ranked.begin(), ranked.end(),
                                          [](const Family& f) { return f.best->credible(); })) {
      settings_.stage("pairs of effects");
      pairs = fit_pairs(context, ranked, fits, all, plain, *held_out_, scores, standards);
    }
    const Judgement judgement = judge(nominal, ranked, pairs, standards);
    report(context, scores, standards, nominal, ranked, fits, pairs, judgement, all);
    return std::move(result_);
  }

private:
  void list_hypotheses() {
    const Structure structure = nominal_.structure(measured_);
    for (const Effect& effect : effects()) {
      std::vector<Hypothesis> own = effect.hypotheses(structure);
      if (own.empty()) result_.not_tried.push_back({effect.name, effect.needs});
      for (Hypothesis& h : own) hypotheses_.push_back(std::move(h));
    }
  }

  std::vector<JudgedFit> fit_all(const FitContext& context, const std::vector<Signature>& all,
                                 const HypothesisFit& plain, const BlockScores& scores,
                                 const Standards& standards) {
    std::vector<JudgedFit> fits(all.size());
    in_parallel(int(all.size()), [&](int i) {
      const Signature& s = all[std::size_t(i)];
      if (s.g.norm() < silent) return;
      fits[std::size_t(i)] =
          judged(fit_of(context, {s.hypothesis}), plain, context, *held_out_, scores, standards);
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
          judged(std::move(fit), plain, context, *held_out_, scores, standards);
    });
  }

  // `fits`: of single hypotheses, where other ways of the same effect are looked for.
  NamedEffect named(const HypothesisFit& fit, std::size_t half, double probability,
                    const std::vector<JudgedFit>& fits) const {
    const Hypothesis& h = *fit.together[half];
    NamedEffect e{.name = h.effect,
                  .place = h.place,
                  .way = h.way,
                  .probability = probability,
                  .parameters = {}};
    std::vector<const HypothesisFit*> ways{&fit};
    if (fit.together.size() == 1)
      for (const JudgedFit& j : fits)
        if (const Hypothesis& other = *j.fit.together[0];
            other.effect == h.effect && other.place == h.place && other.way != h.way)
          ways.push_back(&j.fit);
    Index first = 0;
    for (std::size_t i = 0; i < half; ++i) first += Index(fit.together[i]->parameters.size());
    for (std::size_t i = 0; i < h.parameters.size(); ++i) {
      const Index row = first + Index(i);
      e.parameters.push_back({.name = h.parameters[i].name,
                              .unit = h.parameters[i].unit,
                              .value = fit.values[row],
                              .interval = interval_of(ways, row, h.parameters[i].prior),
                              .z = fit.z[row]});
    }
    return e;
  }

  TriedHypothesis tried(const JudgedFit& j, const HypothesisFit& plain) const {
    TriedHypothesis t{.effects = {},
                      .log_evidence = j.fit.log_evidence,
                      .sampled_log_evidence = j.fit.sampled_log_evidence,
                      .log_bayes_factor = j.log_bayes_factor,
                      .half_width = log_evidence_at_width(j.fit, 0.5) - plain.log_evidence,
                      .double_width = log_evidence_at_width(j.fit, 2) - plain.log_evidence,
                      .chi2 = j.fit.chi2,
                      .chi2_of_means = j.chi2_of_means,
                      .adequate = j.adequate,
                      .share_of_healthy_worse = j.p,
                      .worst_block = j.worst.second,
                      .worst_block_z = j.worst.first,
                      .gap_after = j.gap_after,
                      .held_out_after = j.held_out_after,
                      .absurd = j.absurd,
                      .fails_held_out = j.fails_held_out,
                      .rejected = ""};
    for (std::size_t h = 0; h < j.fit.together.size(); ++h)
      t.effects.push_back(named(j.fit, h, 0, {}));
    if (!j.adequate)
      t.rejected = "does not explain " + j.worst.second;
    else if (j.absurd)
      t.rejected = "only with a value far out of its prior";
    else if (j.fails_held_out)
      t.rejected = "does not predict the held-out readings";
    return t;
  }

  void report(const FitContext& context, const BlockScores& scores, const Standards& standards,
              const JudgedFit& nominal, const std::vector<Family>& ranked,
              const std::vector<JudgedFit>& fits, const std::vector<JudgedFit>& pairs,
              const Judgement& judgement, const std::vector<Signature>& all) {
    settings_.stage("report");
    result_.case_name = case_.name;
    result_.verdict = judgement.verdict;
    result_.probabilities = judgement.probabilities;
    const auto probability = [&](const std::string& effect) {
      for (const auto& [name, p] : judgement.probabilities)
        if (name == effect) return p;
      return 0.;
    };
    for (const JudgedFit* j : judgement.named)
      for (std::size_t h = 0; h < j->fit.together.size(); ++h) {
        const Hypothesis& own = *j->fit.together[h];
        if (std::none_of(result_.effects.begin(), result_.effects.end(), [&](const NamedEffect& e) {
              return e.name == own.effect && e.place == own.place;
            }))
          result_.effects.push_back(named(j->fit, h, probability(own.effect), fits));
      }
    result_.where = located(scores, nominal.fit.deviation);
    for (LocatedGap& gap : residual_energy(nominal_, test_, measured_))
      result_.where.push_back(std::move(gap));
    add_components(ranked);
    result_.trends = level_trends(test_);
    const JudgedFit* first = best_of(nominal, ranked, pairs, judgement);
    add_tried(nominal, ranked, pairs, first);
    for (const Family& f : ranked) result_.evaluations += f.best->fit.evaluations;
    for (NamedEffect& e : result_.effects) add_other_places(e, fits);
    const JudgedFit* other = second_of(ranked, first);
    std::vector<HypothesisFit> shown{first->fit};
    if (other) shown.push_back(other->fit);
    for (HypothesisFit& fit : shown) complete(context, fit);
    const HypothesisFit& best = shown.front();
    const HypothesisFit* second = other ? &shown.back() : nullptr;
    how_far(context, nominal, best, second);
    result_.basis_error = predictors_->of(best.together).basis_error(best.values);
    if (best.together.size() == 1) result_.drifts = drifts(context, best);
    const Structure structure = nominal_.structure(measured_);
    result_.compensators = compensators(context, *held_out_, nominal.fit, structure);
    const Likeness alike = likeness(all);
    result_.effect_names = alike.effects;
    result_.likeness = alike.cosine;
    result_.mimics = mimics(alike);
    result_.detectable = detectable(all);
    overlay(best, second);
    for (const HypothesisFit& fit : shown)
      if (fit.draws.cols() > 0) {
        MatrixXd values(fit.draws.rows(), fit.draws.cols());
        const Predictor& predict = predictors_->of(fit.together);
        for (Index k = 0; k < values.cols(); ++k)
          values.col(k) = predict.values_of(fit.draws.col(k));
        result_.posteriors.emplace_back(name_of(fit), std::move(values));
      }
    plan_next(nominal, ranked, judgement);
    assumptions(standards);
    result_.warnings = test_.warnings;
    result_.hypotheses = int(hypotheses_.size());
    result_.headline = headline(nominal, judgement);
    result_.seconds = watch_.seconds();
  }

  // By evidence, with which of them is the best.
  void add_tried(const JudgedFit& nominal, const std::vector<Family>& ranked,
                 const std::vector<JudgedFit>& pairs, const JudgedFit* best) {
    std::vector<const JudgedFit*> all{&nominal};
    for (const Family& f : ranked) all.push_back(f.best);
    for (const JudgedFit& p : pairs) all.push_back(&p);
    std::stable_sort(all.begin(), all.end(), [](const JudgedFit* a, const JudgedFit* b) {
      return a->log_bayes_factor > b->log_bayes_factor;
    });
    for (const JudgedFit* j : all) {
      if (j == best && j != &nominal) result_.best = result_.tried.size();
      result_.tried.push_back(tried(*j, nominal.fit));
    }
  }

  // Places of the effect, alone, that the readings do not tell from the named one.
  static void add_other_places(NamedEffect& e, const std::vector<JudgedFit>& fits) {
    double own = -1e300;
    for (const JudgedFit& j : fits)
      if (j.fit.together[0]->effect == e.name && j.fit.together[0]->place == e.place)
        own = std::max(own, j.fit.log_evidence);
    constexpr double as_well = 3;
    for (const JudgedFit& j : fits) {
      const Hypothesis& h = *j.fit.together[0];
      if (h.effect == e.name && h.place != e.place && own - j.fit.log_evidence < as_well &&
          std::find(e.other_places.begin(), e.other_places.end(), h.place) == e.other_places.end())
        e.other_places.push_back(h.place);
    }
  }

  // What an effect at a place explains stands for the place.
  void add_components(const std::vector<Family>& ranked) {
    std::map<std::string, double> most;
    for (const Family& f : ranked) {
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
        gap.significant = log_bayes > 3;
        result_.where.push_back(gap);
      }
  }

  static const JudgedFit* best_of(const JudgedFit& nominal, const std::vector<Family>& ranked,
                                  const std::vector<JudgedFit>& pairs, const Judgement& judgement) {
    if (judgement.verdict == Verdict::none) return &nominal;
    if (!judgement.named.empty()) return judgement.named.front();
    if (ranked.empty()) return &nominal;
    // Where none is known, what comes nearest.
    const JudgedFit* best = ranked.front().best;
    for (const Family& f : ranked)
      if (f.best->gap_after < best->gap_after) best = f.best;
    constexpr double worth_a_second = 0.8;
    for (const JudgedFit& p : pairs)
      if (p.gap_after < worth_a_second * best->gap_after) best = &p;
    return best;
  }
  static const JudgedFit* second_of(const std::vector<Family>& ranked, const JudgedFit* best) {
    for (const Family& f : ranked)
      if (f.best != best) return f.best;
    return nullptr;
  }

  void how_far(const FitContext& context, const JudgedFit& nominal, const HypothesisFit& best,
               const HypothesisFit* second) {
    result_.gap = gap_shrink(context, *fitted_, nominal.fit, best);
    if (!held_out_->rows().empty()) {
      result_.held_out = gap_shrink(context, *held_out_, nominal.fit, best);
      for (const std::string& h : measured_.hold_out)
        result_.held_out_how += (result_.held_out_how.empty() ? "" : ", ") + h;
      if (result_.held_out_how.empty())
        result_.held_out_how = "the highest level of each direction";
    } else if (fitted_->rows().size() > 2 && fitted_->rows().size() < 16 &&
               !best.together.empty()) {
      result_.held_out = in_turn(context, nominal.fit, best);
      result_.held_out_how = "each reading in turn, the others fitted";
    }
    const MatrixXd total = uncertainty_.total();
    for (std::size_t i = 0; i < test_.readings.size(); ++i) {
      const Reading& r = test_.readings[i];
      const auto value = [&](const HypothesisFit& fit) {
        const double log_value = log_measured_[Index(i)] - fit.deviation[Index(i)];
        return r.kind == ReadingKind::cross ? std::max(0., std::exp(log_value) - cross_floor)
                                            : std::exp(log_value);
      };
      ComparedReading row{.name = r.name,
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

  void overlay(const HypothesisFit& best, const HypothesisFit* second) {
    for (std::size_t i = 0; i < responses_.responses.size(); ++i)
      for (const FrfSet& set : responses_.responses[i]) {
        if (set.references.empty() || result_.overlays.size() >= 4) continue;
        const Reading* reading = nullptr;
        for (const Reading& r : test_.readings)
          if (r.entry == "frf[" + std::to_string(i) + "]" && r.kind == ReadingKind::amplitude) {
            reading = &r;
            break;
          }
        if (!reading) continue;
        const TestRun& run = test_.runs[std::size_t(reading->run)];
        const std::string channel = run.sensor + "." + "xyz"[run.axis];
        const auto column = std::find(set.responses.begin(), set.responses.end(), channel);
        if (column == set.responses.end()) continue;
        OverlaidResponse o;
        o.name = reading->name.substr(reading->name.find(" at ") + 1);
        o.hertz = set.hertz;
        o.measured = set.H[0].col(column - set.responses.begin()).cwiseAbs();
        const auto magnitude = [&](const HypothesisFit& fit) {
          const auto H = predictors_->of(fit.together).response(fit.values, run, set.hertz);
          return H ? VectorXd(H->cwiseAbs()) : VectorXd();
        };
        o.nominal = predictors_->of({})
                        .response(VectorXd(), run, set.hertz)
                        .value_or(Eigen::VectorXcd())
                        .cwiseAbs();
        o.best = magnitude(best);
        if (second) o.second = magnitude(*second);
        result_.overlays.push_back(std::move(o));
      }
  }

  void plan_next(const JudgedFit& nominal, const std::vector<Family>& ranked,
                 const Judgement& judgement) {
    if (!settings_.plan_next || judgement.verdict == Verdict::pair) return;
    std::vector<RivalHypothesis> rivals;
    constexpr std::size_t most = 4;
    const auto add = [&](const JudgedFit& j) {
      double p = 0.02; // a rival is never quite ruled out
      const std::string name = j.fit.together.empty() ? "none" : j.fit.together[0]->effect;
      for (const auto& [effect, own] : judgement.probabilities)
        if (effect == name) p = std::max(p, own);
      rivals.push_back({j.fit.together, j.fit.values, p});
    };
    if (nominal.adequate) add(nominal);
    for (const JudgedFit* j : judgement.named) add(*j);
    for (const Family& f : ranked)
      if (rivals.size() < most && std::find(judgement.named.begin(), judgement.named.end(),
                                            f.best) == judgement.named.end())
        add(*f.best);
    if (rivals.size() > most) rivals.resize(most);
    settings_.stage("next measurement");
    result_.next =
        next_measurements(case_, nominal_, measured_, test_, rivals, predictors_->families());
    for (const JudgedFit* j : judgement.named)
      for (const Hypothesis* h : j->fit.together)
        for (const std::string& advice : effect_named(h->effect).look_alikes)
          result_.advice.push_back(h->effect + " or " + advice);
  }

  void assumptions(const Standards& standards) {
    const auto add = [&](const char* format, auto... values) {
      std::array<char, 300> text{};
      std::snprintf(text.data(), text.size(), format, values...);
      result_.assumptions.emplace_back(text.data());
    };
    add("%zu readings, %zu of them held out; %zu hypotheses of %zu effects", test_.readings.size(),
        held_out_->rows().size(), hypotheses_.size(), effects().size());
    const auto percent = [](double share) { return 100 * share; };
    add("admissible specimens (%d): modulus %g %%, density %g %%, wall %g %% where the case has no "
        "tolerance, field of stiffness %g %%, masses %g %%, joints %g %%; %zu tolerances of the "
        "case",
        specimens, percent(scatters::modulus), percent(scatters::density),
        percent(scatters::thickness), percent(scatters::field), percent(scatters::masses),
        percent(scatters::joints), case_.tolerances.size());
    add("damping %g %% of all modes alike and %g %% of each; sensors %g %%, %g degree and %g mm, "
        "table %g %% along other axes",
        percent(scatters::all_damping), percent(scatters::mode_damping), percent(scatters::gain),
        scatters::turn, 1e3 * scatters::off_place, percent(scatters::other_axes));
    add("reassembly %g %% of frequencies and %g %% of damping, runs %g %% and %g %%",
        percent(test_sigma::reassembled_frequency), percent(test_sigma::reassembled_damping),
        percent(test_sigma::run_frequency), percent(test_sigma::run_damping));
    add("model %g %% of frequencies, %g %% of damping, %g %% of stiffnesses, %g %% of cross "
        "responses and %g %% of what the meshes differ by",
        percent(test_sigma::numeric_frequency), percent(test_sigma::numeric_damping),
        percent(test_sigma::numeric_stiffness), percent(test_sigma::numeric_cross),
        percent(test_sigma::share_of_correction));
    add("adequate: chi-square at most %.1f over %zu readings and %.1f over their means over the "
        "levels, no block beyond z = %.1f; ln BF over the nominal case at least %.1f",
        standards.chi2, fitted_->rows().size(), standards.chi2_of_means, standards.worst_block,
        standards.evidence);
    for (const std::string& w : settings_.without) result_.assumptions.push_back("left out: " + w);
  }

  const Case& case_;
  const Measured& measured_;
  const DiagnosisData& responses_;
  const DiagnosisSettings& settings_;
  Stopwatch watch_;
  Nominal nominal_;
  TestReadings test_;
  Uncertainty uncertainty_;
  VectorXd log_measured_;
  std::optional<Whitening> fitted_, held_out_;
  std::optional<PredictorStore> predictors_;
  std::vector<Hypothesis> hypotheses_;
  Diagnosis result_;
};

} // namespace

Diagnosis diagnose(const Case& data, const DiagnosisData& test, const DiagnosisSettings& settings) {
  return Work(data, test, settings).diagnosis();
}

} // namespace plica

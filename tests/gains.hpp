// A diagnosis in closed form: each effect multiplies what sensors read, so that the logarithms are
// linear in its size,
//   e = r - sum z_k g_k,   G = [g_1 g_2 ..]
//   ln Z = -1/2 r' (I + G G')^-1 r - 1/2 ln det(I + G G')
// with r and g in standard deviations.
#pragma once

#include "changed_beam.hpp"
#include "diagnose/judge/sets.hpp"
#include "diagnose/weigh/normal_draws.hpp"

#include <deque>
#include <numeric>

namespace plica::test {

inline constexpr double sigma_of_gains = 0.01;

inline std::string sensor_name(Eigen::Index k) {
  return "s" + std::to_string(k);
}

// So many sensors at the end of a beam.
inline Case beam_with_sensors(int count) {
  Case c = changed_beam::beam_of(1, 0.5, 0.02, 0.01, true);
  std::get<BeamPart>(c.parts[0].body).elements = 2;
  c.analyses.modes = Modes{.count = 2};
  for (int k = 0; k < count; ++k) {
    Sensor sensor;
    sensor.name = sensor_name(k);
    sensor.at = {0, 0.5, 0};
    c.sensors.push_back(sensor);
  }
  return c;
}

// A test of what each sensor reads at the first peak.
class Gains {
  using Index = Eigen::Index;
  using MatrixXd = Eigen::MatrixXd;
  using VectorXd = Eigen::VectorXd;

public:
  explicit Gains(int readings)
      : n_(readings), nominal_(nominal_of(beam_with_sensors(readings), Measured())) {
    TestRun run;
    run.input.base = run.axis = 2;
    run.level = 1;
    run.sensor = sensor_name(0);
    run.peaks = {0};
    run.first = true;
    test_.runs = {run};
    for (Index k = 0; k < n_; ++k) {
      Reading r;
      r.kind = ReadingKind::amplitude;
      r.run = 0;
      r.axis = 2;
      r.sensor = sensor_name(k);
      r.sigma = sigma_of_gains;
      test_.readings.push_back(r);
    }
    state_errors();
  }

  VectorXd along(Index reading, double deviations) const {
    return deviations * VectorXd::Unit(n_, reading);
  }

  Hypothesis& add(const std::string& effect, const std::string& place, const VectorXd& g) {
    hypotheses_.push_back({.effect = effect,
                           .place = place,
                           .way = "",
                           .parameters = {{"size", "", {PriorKind::normal, 0, 1}}}});
    hypotheses_.back().setup = [g](TestSetup& setup, const VectorXd& v) {
      for (Index k = 0; k < g.size(); ++k)
        if (g[k] != 0) setup.reading_of(sensor_name(k)) *= std::exp(sigma_of_gains * g[k] * v[0]);
    };
    signatures_.push_back(
        {.hypothesis = &hypotheses_.back(), .z = VectorXd::Ones(1), .g = g, .smallest = {}});
    fitted_alone_.push_back(true);
    return hypotheses_.back();
  }
  // What came last is known by its signature only.
  void leave_out_alone() { fitted_alone_.back() = false; }
  // What came last is none of what is tried.
  void take_away() {
    hypotheses_.pop_back();
    signatures_.pop_back();
    fitted_alone_.pop_back();
  }

  void measure(const VectorXd& r) { measured_ = u_.nominal + sigma_of_gains * r; }

  void hold_out(Index reading) { test_.readings[std::size_t(reading)].held_out = true; }

  // What `ask` says of a search in which all single effects are fitted.
  template <class Ask> auto searched(const DiagnosisSettings& settings, const Ask& ask) {
    PredictorStore predictors(nominal_, test_);
    const Whitening fitted(test_, u_, false), held_out(test_, u_, true);
    const BlockScores scores(test_, u_);
    const FitContext context{predictors, test_, u_, measured_, fitted};
    const Standards standards = standards_of(context, held_out, scores);
    const HypothesisFit plain = nominal_fit(context);
    const JudgedFit nominal = judged(plain, plain, context, held_out, scores, standards);
    std::vector<JudgedFit> fits;
    for (std::size_t i = 0; i < hypotheses_.size(); ++i)
      if (fitted_alone_[i])
        fits.push_back(judged(fit_of(context, {&hypotheses_[i]}), plain, context, held_out, scores,
                              standards));
    const PassedOver none;
    const std::vector<EffectFits> ranked = fits_by_effect(fits);
    return ask(SetSearch{.context = context,
                         .ranked = ranked,
                         .fits = fits,
                         .passed_over = none,
                         .all = signatures_,
                         .nominal = nominal,
                         .held_out = held_out,
                         .scores = scores,
                         .standards = standards,
                         .settings = settings});
  }

  std::vector<JudgedFit> sets(const DiagnosisSettings& settings = {}) {
    return searched(settings, [](const SetSearch& search) { return fit_sets(search); });
  }
  std::vector<JudgedFit> beside_the_best() {
    return searched({}, [](const SetSearch& search) {
      return fit_beside(search, *search.ranked.front().best);
    });
  }

private:
  void state_errors() {
    const Predictor predict(nominal_, test_, {});
    u_.nominal = *predict(VectorXd());
    u_.correction = u_.bias = VectorXd::Zero(n_);
    u_.series.resize(std::size_t(n_));
    std::iota(u_.series.begin(), u_.series.end(), 0);
    u_.measurement = sigma_of_gains * sigma_of_gains * MatrixXd::Identity(n_, n_);
    u_.reassembly = u_.numeric = u_.form = MatrixXd::Zero(n_, n_);
    constexpr Index healthy = 200;
    u_.healthy.resize(n_, healthy);
    NormalDraws normal(1);
    for (double& x : u_.healthy.reshaped()) x = sigma_of_gains * normal();
    measured_ = u_.nominal;
  }

  Index n_;
  Nominal nominal_;
  TestReadings test_;
  Uncertainty u_;
  VectorXd measured_;
  std::deque<Hypothesis> hypotheses_;
  std::vector<Signature> signatures_;
  std::vector<bool> fitted_alone_;
};

} // namespace plica::test

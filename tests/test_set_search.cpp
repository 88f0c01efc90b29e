// The search for sets of effects, on a problem in closed form: each effect multiplies what sensors
// read, so that the logarithms are linear in its size,
//   e = r - sum z_k g_k,   G = [g_1 g_2 ..]
//   ln Z = -1/2 r' (I + G G')^-1 r - 1/2 ln det(I + G G')
// with r and g in standard deviations.
#include "changed_beam.hpp"
#include "diagnose/judge/sets.hpp"
#include "diagnose/weigh/normal_draws.hpp"

#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <numeric>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Effects = std::vector<std::string>;

constexpr double sigma_of_gains = 0.01;

std::string sensor_name(Index k) {
  return "s" + std::to_string(k);
}

// So many sensors at the end of a beam.
Case beam_with_sensors(int count) {
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

  void measure(const VectorXd& r) { measured_ = u_.nominal + sigma_of_gains * r; }

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

  template <class Ask>
  std::vector<JudgedFit> searched(const DiagnosisSettings& settings, const Ask& ask) {
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
    const std::vector<EffectFits> ranked = fits_by_effect(fits);
    return ask({.context = context,
                .ranked = ranked,
                .fits = fits,
                .all = signatures_,
                .nominal = nominal,
                .held_out = held_out,
                .scores = scores,
                .standards = standards,
                .settings = settings});
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

double log_evidence_of(const std::vector<VectorXd>& effects, const VectorXd& r) {
  MatrixXd C = MatrixXd::Identity(r.size(), r.size());
  for (const VectorXd& g : effects) C += g * g.transpose();
  return -r.dot(C.llt().solve(r)) / 2 - std::log(C.determinant()) / 2;
}

const JudgedFit* find(const std::vector<JudgedFit>& sets, const Effects& effects) {
  const auto found = std::find_if(sets.begin(), sets.end(),
                                  [&](const JudgedFit& j) { return j.fit.effects() == effects; });
  return found == sets.end() ? nullptr : &*found;
}

// Each half does much that the other takes back: alone it explains nothing, and sets do not grow
// from it. What imitates what is left of both leads, and nothing beside it helps. Eight readings
// carry no three.
TEST(SetSearch, exchanges_members_for_what_growth_does_not_meet) {
  Gains gains(8);
  const VectorXd half = gains.along(0, 30) + gains.along(1, 4.5),
                 other = gains.along(0, 30) - gains.along(1, 4.5),
                 decoy = gains.along(1, 4) + gains.along(2, 4), r = half - other;
  gains.add("half", "here", half);
  gains.add("other_half", "here", other);
  gains.add("decoy", "here", decoy);
  gains.measure(r);
  for (const VectorXd& g : {half, other})
    EXPECT_LT(log_evidence_of({g}, r), log_evidence_of({}, r)) << "the nominal case";
  const std::vector<JudgedFit> sets = gains.sets();
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(sets.front().fit.effects(), (Effects{"half", "other_half"}));
  EXPECT_NEAR(sets.front().fit.log_evidence, log_evidence_of({half, other}, r), 1e-2);
  const JudgedFit* grown = find(sets, {"decoy", "half"});
  ASSERT_NE(grown, nullptr);
  EXPECT_NEAR(grown->fit.log_evidence, log_evidence_of({decoy, half}, r), 1e-2);
}

// The halves are asked for beside a mass that leads, and then without it.
TEST(SetSearch, tries_a_larger_set_without_each_of_its_members) {
  Gains gains(12);
  const VectorXd half = gains.along(0, 30) + gains.along(1, 4.5),
                 other = gains.along(0, 30) - gains.along(1, 4.5), mass = gains.along(2, 10);
  gains.add("half", "here", half);
  gains.add("other_half", "here", other);
  gains.add("mass", "here", mass);
  gains.measure(mass + half - other);
  const std::vector<JudgedFit> sets = gains.sets();
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(sets.front().fit.effects(), (Effects{"half", "mass", "other_half"}));
  EXPECT_TRUE(sets.front().credible());
  for (const Effects& two :
       {Effects{"half", "mass"}, Effects{"mass", "other_half"}, Effects{"half", "other_half"}})
    EXPECT_NE(find(sets, two), nullptr) << two[0] << " and " << two[1];
}

// One place in two ways, one end let go by two, what gave way to a cause, what slips in a test at
// one level: none of them joins.
TEST(SetSearch, joins_only_what_can_act_together) {
  Gains gains(8);
  constexpr double size = 8;
  gains.add("gain", "tip", gains.along(0, size)).way = "x";
  gains.add("gain", "tip", gains.along(1, size)).way = "y";
  constexpr int end = 100000; // a node that is not there
  gains.add("clamp", "left", gains.along(2, size)).released = {end};
  gains.add("fixture", "left", gains.along(3, size)).released = {end};
  gains.add("mass", "tip", gains.along(4, size));
  gains.add("part", "part", gains.along(5, size)).names_place_only = true;
  gains.leave_out_alone();
  gains.add("slip", "joint", gains.along(6, size)).softening = [](const VectorXd&) {
    return Softening();
  };
  gains.leave_out_alone();
  VectorXd r = VectorXd::Constant(8, size);
  r[7] = 0;
  gains.measure(r);
  const std::vector<JudgedFit> sets = gains.sets();
  for (const Effects& two : {Effects{"clamp", "gain"}, Effects{"gain", "mass"},
                             Effects{"clamp", "mass"}, Effects{"fixture", "gain"}})
    EXPECT_NE(find(sets, two), nullptr) << two[0] << " and " << two[1];
  for (const JudgedFit& j : sets) {
    const Effects effects = j.fit.effects();
    const auto count = [&](const char* name) {
      return std::count(effects.begin(), effects.end(), name);
    };
    EXPECT_LE(count("gain"), 1);
    EXPECT_LE(count("clamp") + count("fixture"), 1);
    EXPECT_EQ(count("part") + count("slip"), 0);
  }
}

// Of one effect at six places, each worth one more though errors were as large as what is left.
TEST(SetSearch, ends_at_five_effects) {
  Gains gains(15); // three for each of five parameters
  VectorXd r = VectorXd::Zero(15);
  constexpr std::array<double, 6> sizes{300, 120, 50, 20, 12, 12};
  for (Index k = 0; k < 6; ++k) {
    const VectorXd g = gains.along(k, sizes[std::size_t(k)]);
    gains.add("mass", "place" + std::to_string(k), g);
    r += g;
  }
  gains.measure(r);
  const std::vector<JudgedFit> sets = gains.sets();
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(sets.front().fit.together.size(), 5u);
  for (const JudgedFit& j : sets) EXPECT_LE(j.fit.together.size(), 5u);
}

TEST(SetSearch, finds_beside_what_leads_what_its_residual_asks_for) {
  Gains gains(8);
  const VectorXd mass = gains.along(0, 10), gain = gains.along(1, 5), idle = gains.along(2, 5);
  gains.add("mass", "here", mass);
  gains.add("gain", "here", gain);
  gains.add("idle", "here", idle);
  gains.measure(mass + gain);
  const std::vector<JudgedFit> beside = gains.beside_the_best();
  ASSERT_EQ(beside.size(), 1u);
  EXPECT_EQ(beside.front().fit.effects(), (Effects{"gain", "mass"}));
  EXPECT_NEAR(beside.front().fit.log_evidence, log_evidence_of({mass, gain}, mass + gain), 1e-2);
}

TEST(SetSearch, finds_nothing_where_it_is_stopped_at_once) {
  Gains gains(8);
  gains.add("mass", "here", gains.along(0, 10));
  gains.add("gain", "here", gains.along(1, 10));
  gains.measure(gains.along(0, 10) + gains.along(1, 10));
  DiagnosisSettings settings;
  settings.stop = [] { return true; };
  EXPECT_TRUE(gains.sets(settings).empty());
  EXPECT_FALSE(gains.sets().empty());
}

} // namespace
} // namespace plica

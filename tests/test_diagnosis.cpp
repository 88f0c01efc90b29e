// The parts of a diagnosis against closed forms, and whole diagnoses of made-up tests.
#include "changed_beam.hpp"
#include "diagnose/diagnose.hpp"
#include "diagnose/predict/peak_choice.hpp"
#include "diagnose/weigh/blocks.hpp"
#include "diagnose/weigh/evidence.hpp"
#include "diagnose/weigh/interval.hpp"
#include "model/description/case.hpp"
#include "model/description/case_path.hpp"
#include "run/results/normal_distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

namespace plica {
namespace {

using Eigen::VectorXd;
using Complex = std::complex<double>;

TEST(Priors, coordinates_are_standard_normal) {
  EXPECT_DOUBLE_EQ(value_of({PriorKind::normal, 2, 3}, 1), 5);
  EXPECT_DOUBLE_EQ(value_of({PriorKind::log_normal, 2, 0.5}, -2), 2 * std::exp(-1));
  EXPECT_NEAR(value_of({PriorKind::uniform, 1, 5}, 0), 3, 1e-12);
  EXPECT_NEAR(value_of({PriorKind::uniform, 0, 1}, 1.6448536), 0.95, 1e-6);
}

TEST(Scores, a_normal_quantile_is_the_inverse_of_its_share) {
  EXPECT_NEAR(normal_quantile(0.975), 1.959963985, 1e-8);
  EXPECT_NEAR(normal_share(-1.959963985), 0.025, 1e-9);
}

// A cantilever with three masses, one of which may be missing, and a sensor at its tip.
Case cantilever() {
  Case c;
  c.name = "cantilever";
  c.materials["aluminium"] = {.E = 70e9, .nu = 0.33, .rho = 2700};
  BeamPart beam;
  beam.points = {{0, 0, 0}, {0, 0.2, 0}, {0, 0.4, 0}, {0, 0.6, 0}};
  beam.elements = 4;
  beam.up = {0, 0, 1};
  beam.section.shape = BeamShape::rectangle;
  beam.section.material = "aluminium";
  beam.section.width = 0.03;
  beam.section.depth = 0.005;
  c.parts.push_back({"beam", beam});
  changed_beam::add_masses(c);
  Cap root;
  root.name = "root";
  root.of = {"beam.start"};
  c.caps.push_back(root);
  c.mount.push_back({.cap = "root"});
  Sensor tip;
  tip.name = "tip";
  tip.at = {0, 0.6, 0};
  c.sensors.push_back(tip);
  c.analyses.modes = Modes{.count = 8};
  c.analyses.damping.modal = 0.01;
  return c;
}

// What the nominal model of a case reads, as a test of mass and five frequencies. With four, a
// middle stretch that has lost 92 % explains a modulus lowered to a third within its uncertainty.
Measured test_of(const Case& truth, const Case& nominal) {
  Measured m;
  m.specimen = nominal.name;
  for (const auto& [axis, order] :
       {std::pair{Axis::x, 1}, {Axis::x, 2}, {Axis::z, 1}, {Axis::z, 2}, {Axis::z, 3}})
    m.modes.push_back(changed_beam::damped_mode(MeasuredShape::transverse, axis, order));
  m.weighings = {{.value = 1, .sigma = 0.0005, .repeats = {}}};
  changed_beam::take_readings(m, changed_beam::read_by(truth, m));
  return m;
}

Diagnosis diagnosis_of(const Case& truth, const Case& nominal) {
  DiagnosisSettings settings;
  settings.plan_next = false;
  return diagnose(nominal, {.data = test_of(truth, nominal), .responses = {}}, settings);
}

TEST(Diagnose, finds_nothing_where_there_is_nothing) {
  const Diagnosis d = diagnosis_of(cantilever(), cantilever());
  EXPECT_EQ(d.verdict, Verdict::none) << d.headline;
  EXPECT_LT(d.gap.before, 0.3);
  EXPECT_FALSE(d.best.has_value());
}

TEST(Diagnose, names_a_mass_that_is_missing) {
  Case truth = cantilever();
  *number_at(truth, "parts.m2.mass") = 1e-6;
  const Diagnosis d = diagnosis_of(truth, cantilever());
  ASSERT_EQ(d.verdict, Verdict::identified) << d.headline;
  EXPECT_EQ(d.effects.front().name, "component_mass");
  EXPECT_EQ(d.effects.front().place, "m2");
  EXPECT_LT(d.effects.front().parameters.front().value, 0.1);
  EXPECT_GT(d.gap.shrink(), 0.8);
  // What the gap is closed with is the one that is named, not the one whose gap is nearest.
  ASSERT_TRUE(d.best.has_value());
  ASSERT_EQ(d.tried[*d.best].effects.size(), 1U);
  EXPECT_EQ(d.tried[*d.best].effects.front().place, "m2");
  EXPECT_NEAR(d.tried[*d.best].gap_after, d.gap.after, 1e-9);
}

TEST(Diagnose, calls_modulus_lowered_to_a_third_no_effect_it_knows) {
  Case truth = cantilever();
  *number_at(truth, "materials.aluminium.E") = 20e9;
  const Diagnosis d = diagnosis_of(truth, cantilever());
  EXPECT_EQ(d.verdict, Verdict::unknown) << d.headline;
  ASSERT_FALSE(d.compensators.empty());
  EXPECT_NEAR(d.compensators.front().factor, 20. / 70, 0.02);
  EXPECT_GT(d.compensators.front().prior_sigmas, 50);
}

// Modes two to four of a beam that is so soft that the second lies where the first should: by one
// factor all is met, of other modes than those that lie nearest.
TEST(Diagnose, says_of_a_tempting_modulus_that_it_takes_modes_for_others) {
  const Case nominal = cantilever();
  Measured m;
  m.specimen = nominal.name;
  for (int order = 1; order <= 4; ++order)
    m.modes.push_back(changed_beam::bending(Axis::z, order, ""));
  const Eigen::VectorXd y = changed_beam::read_by(nominal, m);
  const double factor = std::exp(2 * (y[0] - y[1]));
  m.modes.clear();
  for (int k = 1; k < 4; ++k) {
    m.modes.push_back(changed_beam::bending(Axis::z, k, "", std::exp(y[k]) * std::sqrt(factor)));
    m.modes.back().shape = MeasuredShape::other;
  }
  DiagnosisSettings settings;
  settings.plan_next = false;
  const Diagnosis d = diagnose(nominal, {.data = m, .responses = {}}, settings);
  const auto modulus =
      std::find_if(d.compensators.begin(), d.compensators.end(),
                   [](const Compensator& c) { return c.on == FreeFactor::modulus; });
  ASSERT_NE(modulus, d.compensators.end());
  EXPECT_LT(modulus->factor, 0.2);
  EXPECT_NE(modulus->contradicted_by.find("taken for another mode"), std::string::npos)
      << modulus->contradicted_by;
}

TEST(Diagnose, is_the_same_every_time) {
  Case truth = cantilever();
  *number_at(truth, "parts.m1.mass") = 0.06;
  const Diagnosis a = diagnosis_of(truth, cantilever()), b = diagnosis_of(truth, cantilever());
  EXPECT_EQ(a.headline, b.headline);
  ASSERT_EQ(a.tried.size(), b.tried.size());
  for (std::size_t i = 0; i < a.tried.size(); ++i)
    EXPECT_EQ(a.tried[i].log_evidence, b.tried[i].log_evidence);
}

// Three setups at one level: ln 163, ln 131, ln 147 scatter by 0.1093, two degrees of freedom.
TEST(Repeats, widen_what_the_test_leaves_unsaid) {
  Measured m;
  for (double frequency : {163., 131., 147.}) {
    MeasuredMode mode;
    mode.shape = MeasuredShape::axial;
    mode.direction = mode.base = Axis::y;
    mode.level = 20;
    mode.frequency = frequency;
    m.modes.push_back(mode);
  }
  m.modes.front().sigma = 1; // Hz
  const TestReadings test = readings_of({.data = m, .responses = {}});
  ASSERT_EQ(test.readings.size(), 3U);
  const double mean = (std::log(163.) + std::log(131.) + std::log(147.)) / 3;
  double sum = 0;
  for (double f : {163., 131., 147.}) sum += std::pow(std::log(f) - mean, 2);
  for (const Reading& r : test.readings)
    EXPECT_NEAR(r.sigma, r.value == 163 ? 1. / 163 : std::sqrt(sum / 2), 1e-12);
  EXPECT_EQ(test.warnings.size(), 1U);
}

// Weighed by 1 / sigma^2: of 100 Hz +- 1 Hz twice and 102 Hz +- 0.5 Hz, ln. Another order, another
// state and a transverse mode that may be the other of a pair stay apart.
TEST(Repeats, of_a_mode_known_by_its_kind_are_one_reading) {
  Measured m;
  m.states = {{.name = "before", .baseline = true, .set = {}, .numbers = {}},
              {.name = "after", .baseline = false, .set = {}, .numbers = {}}};
  const auto add = [&](double frequency, double sigma, int order, const char* state) {
    MeasuredMode mode;
    mode.shape = MeasuredShape::transverse;
    mode.direction = Axis::z;
    mode.order = order;
    mode.state = state;
    mode.frequency = frequency;
    mode.sigma = sigma;
    m.modes.push_back(mode);
  };
  add(100, 1, 1, "before");
  add(100, 1, 1, "before");
  add(102, 0.5, 1, "before");
  add(300, 1, 2, "before");
  add(101, 1, 1, "after");
  const TestReadings test = readings_of({.data = m, .responses = {}});
  ASSERT_EQ(test.readings.size(), 3U);
  const double own = 1e4, other = std::pow(102 / 0.5, 2);
  EXPECT_NEAR(test.readings[0].log_value,
              (2 * own * std::log(100.) + other * std::log(102.)) / (2 * own + other), 1e-12);
  EXPECT_NEAR(test.readings[0].sigma, 1 / std::sqrt(2 * own + other), 1e-12);
  EXPECT_EQ(test.readings[0].name, "transverse mode 1 in z, before, mean of 3");
  m.modes.resize(2);
  for (MeasuredMode& mode : m.modes) mode.direction.reset();
  EXPECT_EQ(readings_of({.data = m, .responses = {}}).readings.size(), 2U);
}

// Two resonances, of which a stop takes the lower away at the highest level.
TEST(Readings, a_peak_that_is_gone_at_the_next_level_is_said) {
  const auto sweep = [](double lower) {
    FrfSet set;
    set.quantity = FrfQuantity::transmissibility;
    set.hertz = VectorXd::LinSpaced(4000, 50, 900);
    set.responses = {"mid.z"};
    set.references = {"base.z"};
    set.H.emplace_back(set.hertz.size(), 1);
    for (Eigen::Index k = 0; k < set.hertz.size(); ++k) {
      const double a = set.hertz[k] / 125, b = set.hertz[k] / 700;
      set.H[0](k, 0) = 1. + lower * a * a / Complex(1 - a * a, 0.02 * a) +
                       0.5 * b * b / Complex(1 - b * b, 0.02 * b);
    }
    return set;
  };
  const auto warnings = [&](double at_ten) {
    TestData test;
    for (double level : {1., 3., 10.}) {
      MeasuredFrf entry;
      entry.base = Axis::z;
      entry.level = level;
      test.data.frf.push_back(entry);
      test.responses.push_back({sweep(level < 10 ? 1 : at_ten)});
    }
    return readings_of(test).warnings;
  };
  EXPECT_TRUE(warnings(1).empty());
  ASSERT_EQ(warnings(0.02).size(), 1U);
  EXPECT_NE(warnings(0.02).front().find("frf[2]: the highest peak at 3 m/s2, 125 Hz"),
            std::string::npos)
      << warnings(0.02).front();
}

// The mass alone was measured, 2 % above what the case has, and 1 % is its standard deviation.
struct OneReading {
  static constexpr double sigma = 0.01;
  OneReading() : nominal(cantilever()), data(test_of(nominal, nominal)) {
    data.weighings.front().value *= 1.02;
    data.modes.clear();
    test = readings_of({.data = data, .responses = {}});
    model = nominal_of(nominal, data);
    u.nominal = *Predictor(model, test, {})(VectorXd());
    u.correction = u.bias = VectorXd::Zero(1);
    u.series = {0};
    u.measurement = Eigen::MatrixXd::Constant(1, 1, sigma * sigma);
    u.reassembly = u.numeric = u.form = Eigen::MatrixXd::Zero(1, 1);
    u.healthy = Eigen::MatrixXd::Zero(1, 10);
    measured = VectorXd::Constant(1, test.readings[0].log_value);
    white.emplace(test, u, false);
    store.emplace(model, test);
    masses = component_mass().hypotheses(model.structure(data));
  }
  FitContext context() { return {*store, test, u, measured, *white}; }

  Case nominal;
  Measured data;
  TestReadings test;
  Nominal model;
  Uncertainty u;
  VectorXd measured;
  std::optional<Whitening> white;
  std::optional<PredictorStore> store;
  std::vector<Hypothesis> masses;
};

// Two parameters of which only the sum shows, at a brink: I + J'J is singular to rounding. Its
// determinant is 1 + 2 s^2, and each parameter keeps half of the variance of its prior.
TEST(Evidence, stands_where_the_readings_fall_off_steeply) {
  constexpr double steep = 1e9;
  HypothesisFit fit;
  fit.z = VectorXd::Zero(2);
  fit.error = VectorXd::Zero(1);
  fit.J = Eigen::MatrixXd::Constant(1, 2, steep);
  EXPECT_NEAR(log_evidence_at_width(fit, 1), -std::log1p(2 * steep * steep) / 2, 1e-9);
  const Eigen::MatrixXd covariance = dispersed_covariance(fit, 1);
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(covariance(i, i), 0.5, 1e-9);
  EXPECT_NEAR(covariance(0, 1), -0.5, 1e-9);
}

// One reading, one parameter: everything is Gaussian, so ln Z is known.
TEST(Evidence, laplace_and_markov_chains_meet_the_closed_form) {
  OneReading one;
  const FitContext context = one.context();
  Hypothesis& h = one.masses.front();
  const double width = 0.02; // of a ratio: small, so that ln mass is straight
  h.parameters.front().prior = {PriorKind::normal, 1, width};
  HypothesisFit fit = fit_of(context, {&h});
  ASSERT_TRUE(fit.solved);
  const double total = one.model.mass;
  const double slope =
      std::get<PointMass>(one.nominal.parts[1].body).mass / total * width / OneReading::sigma;
  const double r = std::log(1.02) / OneReading::sigma;
  const double exact = -r * r / (2 * (1 + slope * slope)) - std::log(1 + slope * slope) / 2;
  EXPECT_NEAR(fit.log_evidence, exact, 2e-3);
  sample(context, fit, 400, 1);
  ASSERT_TRUE(fit.sampled_log_evidence.has_value());
  EXPECT_NEAR(*fit.sampled_log_evidence, exact, 0.1);
}

// What is kept of a hypothesis is not taken for another one that lies where it lay.
TEST(Evidence, a_hypothesis_in_the_place_of_another_is_not_taken_for_it) {
  OneReading one;
  std::optional<Hypothesis> h = one.masses.front();
  const VectorXd doubled = VectorXd::Constant(1, 2);
  const double first = (*one.store->of({&*h})(doubled))[0];
  const Hypothesis* place = &*h;
  h.emplace(one.masses.back());
  ASSERT_EQ(place, &*h);
  const double last = (*one.store->of({&*h})(doubled))[0];
  EXPECT_GT(std::abs(last - first), 1e-3);
}

// A parameter that acts by its square: both signs are found, and its interval holds both.
TEST(Evidence, a_sign_that_does_not_show_is_left_open) {
  OneReading one;
  const FitContext context = one.context();
  Hypothesis& h = one.masses.front();
  const double mass = std::get<PointMass>(one.nominal.parts[1].body).mass;
  // Twice the reading's 2 % at z = 1.41, so that the optimum is near one.
  const double per_square = 0.02 * one.model.mass / mass;
  h.parameters.front().prior = {PriorKind::normal, 0, 1};
  h.coefficients = [per_square, of_one = h.coefficients](const VectorXd& v) {
    return of_one(VectorXd::Constant(1, 1 + per_square * v[0] * v[0]));
  };
  HypothesisFit fit = fit_of(context, {&h});
  ASSERT_TRUE(fit.solved);
  ASSERT_EQ(fit.others.size(), 1U);
  EXPECT_NEAR(fit.others.front()[0], -fit.z[0], 1e-2);
  sample(context, fit, 400, 1);
  const auto [low, high] = interval_of({&fit}, 0, h.parameters.front().prior).ends;
  EXPECT_LT(low, -0.7);
  EXPECT_GT(high, 0.7);
}

// An error that two readings share moves their mean, not their difference.
TEST(Evidence, a_shared_error_leaves_differences_sharp) {
  TestReadings test;
  test.readings.resize(2);
  Uncertainty u;
  u.measurement = Eigen::MatrixXd::Identity(2, 2);
  u.reassembly = u.numeric = u.form = Eigen::MatrixXd::Zero(2, 2);
  const Whitening white = Whitening(test, u, false).widened(Eigen::MatrixXd::Constant(2, 2, 4));
  EXPECT_NEAR(white(Eigen::Vector2d(1, -1)).squaredNorm(), 2, 1e-12);
  EXPECT_NEAR(white(Eigen::Vector2d(1, 1)).squaredNorm(), 2. / 9, 1e-12);
  EXPECT_NEAR(white.log_det(), std::log(9.) / 2, 1e-12);
}

// As many as were measured, though one is weak; none far out of the band.
TEST(PeakChoice, takes_as_many_as_were_measured) {
  const VectorXd hertz = (VectorXd(5) << 50, 100, 101, 300, 900).finished(),
                 zeta = VectorXd::Constant(5, 0.02),
                 height = (VectorXd(5) << 0, 10, 4, 0.5, 20).finished();
  using Chosen = std::vector<Eigen::Index>;
  EXPECT_EQ(strong_peaks(hertz, zeta, height, {80, 400}, 1), (Chosen{1}));
  EXPECT_EQ(strong_peaks(hertz, zeta, height, {80, 400}, 2), (Chosen{1, 3}));
  EXPECT_EQ(strong_peaks(hertz, zeta, height, {}, 1), (Chosen{1, 4}));
}

} // namespace
} // namespace plica

// The parts of a diagnosis against closed forms, and whole diagnoses of made-up tests.
#include "diagnose/diagnose.hpp"
#include "diagnose/gap/blocks.hpp"
#include "diagnose/gap/evidence.hpp"
#include "diagnose/gap/response_peaks.hpp"
#include "model/case.hpp"
#include "model/case_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace plica {
namespace {

using Eigen::VectorXd;
using Complex = std::complex<double>;

TEST(ResponsePeaks, a_noisy_resonance_gives_its_frequency_width_and_height) {
  const double f0 = 200, zeta = 0.012, gain = 1.3;
  VectorXd hertz = VectorXd::LinSpaced(401, 100, 300);
  Eigen::VectorXcd H(hertz.size());
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.01);
  for (Eigen::Index k = 0; k < hertz.size(); ++k) {
    const double r = hertz[k] / f0;
    H[k] = 1. + gain * r * r / Complex(1 - r * r, 2 * zeta * r);
    H[k] *= 1. + Complex(noise(random), noise(random));
  }
  const auto peaks = response_peaks(hertz, H, 0.2);
  ASSERT_EQ(peaks.size(), 1U);
  EXPECT_NEAR(peaks[0].frequency / f0, 1, 1e-3);
  EXPECT_NEAR(peaks[0].damping / zeta, 1, 0.03);
  EXPECT_NEAR(peaks[0].amplitude / (gain / (2 * zeta)), 1, 0.02);
}

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
  for (int k = 2; k <= 4; ++k) {
    PointMass mass;
    mass.at = "beam.point[" + std::to_string(k) + "]";
    mass.mass = 0.02 + 0.01 * k;
    c.parts.push_back({"m" + std::to_string(k - 1), mass});
  }
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
  for (const auto& [shape, axis, order] : {std::tuple{MeasuredShape::transverse, Axis::x, 1},
                                           {MeasuredShape::transverse, Axis::x, 2},
                                           {MeasuredShape::transverse, Axis::z, 1},
                                           {MeasuredShape::transverse, Axis::z, 2},
                                           {MeasuredShape::transverse, Axis::z, 3}}) {
    MeasuredMode mode;
    mode.shape = shape;
    mode.direction = axis;
    mode.order = order;
    mode.frequency = 1;
    mode.damping = 0.01;
    m.modes.push_back(mode);
  }
  m.mass = MeasuredMass{.value = 1, .sigma = 0.0005, .repeats = {}};
  const DiagnosisData blank{.data = m, .responses = {}};
  const TestReadings readings = readings_of(blank);
  const Nominal model = nominal_of(truth, m);
  const VectorXd y = *Predictor(model, readings, {})(VectorXd());
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const Reading& r = readings.readings[std::size_t(i)];
    if (r.kind == ReadingKind::mass) m.mass->value = std::exp(y[i]);
    if (r.kind == ReadingKind::frequency)
      m.modes[std::size_t(r.entry[6] - '0')].frequency = std::exp(y[i]);
  }
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

// One reading, one parameter: everything is Gaussian, so ln Z is known.
TEST(Evidence, laplace_and_markov_chains_meet_the_closed_form) {
  const Case nominal = cantilever();
  Measured m = test_of(nominal, nominal);
  m.mass->value *= 1.02;
  m.modes.clear();
  const DiagnosisData data{.data = m, .responses = {}};
  const TestReadings test = readings_of(data);
  const Nominal model = nominal_of(nominal, m);
  Uncertainty u;
  u.nominal = *Predictor(model, test, {})(VectorXd());
  u.correction = u.bias = VectorXd::Zero(1);
  const double sigma = 0.01;
  u.measurement = Eigen::MatrixXd::Constant(1, 1, sigma * sigma);
  u.reassembly = u.numeric = u.form = Eigen::MatrixXd::Zero(1, 1);
  u.healthy = Eigen::MatrixXd::Zero(1, 10);
  const VectorXd measured = VectorXd::Constant(1, test.readings[0].log_value);
  const Whitening white(test, u, false);
  PredictorStore store(model, test);
  const FitContext context{store, test, u, measured, white};
  std::vector<Hypothesis> all = component_mass().hypotheses(model.structure(m));
  Hypothesis& h = all.front();
  const double width = 0.02; // of a ratio: small, so that ln mass is straight
  h.parameters.front().prior = {PriorKind::normal, 1, width};
  HypothesisFit fit = fit_of(context, {&h});
  ASSERT_TRUE(fit.solved);
  const double total = model.mass;
  const double slope = std::get<PointMass>(nominal.parts[1].body).mass / total * width / sigma;
  const double r = std::log(1.02) / sigma;
  const double exact = -r * r / (2 * (1 + slope * slope)) - std::log(1 + slope * slope) / 2;
  EXPECT_NEAR(fit.log_evidence, exact, 2e-3);
  sample(context, fit, 400, 1);
  ASSERT_TRUE(fit.sampled_log_evidence.has_value());
  EXPECT_NEAR(*fit.sampled_log_evidence, exact, 0.1);
}

} // namespace
} // namespace plica

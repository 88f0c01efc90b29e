// A fixture whose centre of mass lies beside the pipe: what moves it along rocks it, so that axial
// and lateral motion are one.
#include "diagnose/diagnose.hpp"
#include "diagnose/predict/predictor.hpp"
#include "tests/changed_beam.hpp"
#include "words/directions.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace plica::fixture_beside {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr double zeta = 0.01, density = 7850;
using Matrix66 = Eigen::Matrix<double, 6, 6>;

// Of so stiff a steel that it is rigid.
Case short_beam() {
  Case c = changed_beam::beam_of(1, 0.06, 0.03, 0.03, true);
  c.materials["steel"].E *= 1e3;
  c.analyses.damping.modal = zeta;
  c.sensors = {{.name = "tip", .at = {0, 0.06, 0}}};
  return c;
}

Hypothesis fixture(const Nominal& nominal, const std::string& way, bool reads_across = true) {
  Structure s = nominal.structure(Measured());
  s.reads_across = reads_across;
  for (Hypothesis& h : effect_named("fixture_flexibility").hypotheses(s))
    if (h.place == "mount.root" && h.way == way) return h;
  throw std::out_of_range("no fixture beside the pipe");
}

// Of a response at a sensor to the table, per its motion.
VectorXcd response(const Predictor& predict, const VectorXd& values, const std::string& sensor,
                   int base, int axis, const VectorXd& hertz) {
  const TestRun run{.state = "",
                    .input = {.base = base, .force = ""},
                    .sensor = sensor,
                    .axis = axis,
                    .peaks = {}};
  return *predict.response(values, run, hertz);
}

TestReadings at_tip() {
  TestReadings test;
  test.runs.emplace_back();
  test.readings.emplace_back();
  test.readings[0].run = 0;
  test.readings[0].kind = ReadingKind::amplitude;
  test.readings[0].sensor = "tip";
  return test;
}

// A rigid body about a point: its mass, its centre from there, its inertia about its centre.
Matrix66 rigid_body(double mass, const Vector3d& centre, const Matrix3d& inertia) {
  Matrix3d cross;
  cross << 0, -centre[2], centre[1], centre[2], 0, -centre[0], -centre[1], centre[0], 0;
  Matrix66 M = Matrix66::Zero();
  M.topLeftCorner<3, 3>() = mass * Matrix3d::Identity();
  M.topRightCorner<3, 3>() = -mass * cross;
  M.bottomLeftCorner<3, 3>() = mass * cross;
  M.bottomRightCorner<3, 3>() = inertia - mass * cross * cross;
  return M;
}

// The beam is rigid and one with the fixture: six equations,
//   (K - w2 M) q = w2 M r,   M = beam + fixture,   K = m (2 pi f)2, J (2 pi f c)2,
// with the fixture a cube of m = rho a3 spread s times, J = m (s a)2 / 6. Modal damping.
TEST(FixtureBeside, moves_as_six_equations_of_rigid_bodies_say) {
  const double mass = 2, f = 90, rocking = 1.2, spread = 1.3, off_z = 0.05;
  const double edge = std::cbrt(mass / density), J = mass * std::pow(spread * edge, 2) / 6;
  const double length = 0.06, side = 0.03, own = density * side * side * length;
  const Vector3d centre(0, length / 2, 0), off(0, 0, off_z);
  const double across = own * (length * length + side * side) / 12, along = own * side * side / 6;
  const Matrix66 M = rigid_body(own, centre, Vector3d(across, along, across).asDiagonal()) +
                     rigid_body(mass, off, J * Matrix3d::Identity());
  const double w = 2 * std::numbers::pi * f;
  Eigen::Matrix<double, 6, 1> k;
  k << Vector3d::Constant(mass * w * w), Vector3d::Constant(J * std::pow(w * rocking, 2));
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(MatrixXd(k.asDiagonal()),
                                                                 MatrixXd(M));
  const Nominal nominal = nominal_of(short_beam(), Measured());
  const Hypothesis h = fixture(nominal, "beside in z");
  const TestReadings test = at_tip();
  const Predictor predict(nominal, test, {&h});
  const VectorXd hertz = VectorXd::LinSpaced(60, 30, 200);
  VectorXd values(5);
  values << mass, f, rocking, spread, off_z;
  for (int base : {0, 1, 2})
    for (int axis : {0, 1, 2}) {
      VectorXcd expected = VectorXcd::Constant(hertz.size(), axis == base ? 1. : 0.);
      const VectorXd load = M.col(base);
      Eigen::Matrix<double, 1, 6> at = Eigen::Matrix<double, 1, 6>::Unit(axis);
      at.tail<3>() = Vector3d(0, length, 0).cross(Vector3d::Unit(axis)); // (w x l) . e
      for (Index j = 0; j < 6; ++j)
        for (Index i = 0; i < hertz.size(); ++i) {
          const double l = modes.eigenvalues()[j], o = 2 * std::numbers::pi * hertz[i];
          const double shape = at.dot(modes.eigenvectors().col(j)),
                       force = modes.eigenvectors().col(j).dot(load);
          expected[i] +=
              o * o * shape * force / std::complex<double>(l - o * o, 2 * zeta * std::sqrt(l) * o);
        }
      const VectorXcd found = response(predict, values, "tip", base, axis, hertz);
      EXPECT_LT((found - expected).cwiseAbs().maxCoeff(),
                0.01 * expected.cwiseAbs().maxCoeff() + 1e-9)
          << axis_word(base) << " to " << axis_word(axis);
      if (base != 0 && axis != 0) {
        EXPECT_GT(expected.cwiseAbs().maxCoeff(), 0.3);
      }
    }
}

// What a case says in its place: a cap with the fixture's mass beside it, on springs.
Case on_fixture(const Case& held, const Hypothesis& h, const VectorXd& values) {
  Case c = held;
  for (const CaseEdit& edit : h.in_case(held, values)) {
    const auto numbers = [&] {
      std::vector<double> list;
      for (std::size_t at = 0; at < edit.value.size();) {
        const std::size_t from = edit.value.find_first_of("-0123456789", at);
        if (from == std::string::npos) break;
        std::size_t used = 0;
        list.push_back(std::stod(edit.value.substr(from), &used));
        at = from + used;
      }
      return list;
    }();
    if (edit.path == "mount.root") {
      c.mount[0].kind = MountKind::springs;
      std::copy_n(numbers.begin(), 6, c.mount[0].stiffness.begin());
    }
    if (edit.path == "caps.root.mass") c.caps[0].mass = numbers[0];
    if (edit.path == "caps.root.inertia")
      std::copy_n(numbers.begin(), 6, c.caps[0].inertia.begin());
    if (edit.path == "caps.root.offset") std::copy_n(numbers.begin(), 3, c.caps[0].offset.begin());
  }
  return c;
}

Case slender() {
  Case c = changed_beam::beam_of(4, 0.4, 0.03, 0.012, true);
  c.analyses.damping.modal = zeta;
  c.sensors = {{.name = "tip", .at = {0, 0.4, 0}}, {.name = "mid", .at = {0, 0.2, 0}}};
  return c;
}

VectorXd beside() {
  VectorXd values(5);
  values << 1.5, 90, 1.5, 1.3, 0.06;
  return values;
}

TEST(FixtureBeside, is_a_cap_with_an_offset_in_the_case) {
  const Nominal nominal = nominal_of(slender(), Measured());
  const Hypothesis h = fixture(nominal, "beside in z");
  const TestReadings none;
  const AffineModes acting = *Predictor(nominal, none, {&h}).modes(beside());
  const Nominal drawn = nominal_of(on_fixture(slender(), h, beside()), Measured());
  const AffineModes modes = *Predictor(drawn, none, {}).modes(VectorXd());
  for (Index i = 0; i < 6; ++i) EXPECT_NEAR(acting.lambda[i] / modes.lambda[i], 1, 2e-3) << i;
}

TEST(FixtureBeside, is_tried_where_motion_across_is_read_alone) {
  const Nominal nominal = nominal_of(slender(), Measured());
  EXPECT_NO_THROW(fixture(nominal, "beside in x"));
  EXPECT_THROW(fixture(nominal, "beside in x", false), std::out_of_range);
}

// Sweeps along the beam and across it, of the case with the fixture drawn.
TestData sweeps_of(const Case& truth) {
  TestData test;
  test.data.specimen = truth.name;
  const Nominal model = nominal_of(truth, test.data);
  const TestReadings none;
  const Predictor predict(model, none, {});
  const AffineModes modes = *predict.modes(VectorXd());
  for (int base : {1, 2}) {
    MeasuredFrf entry;
    entry.base = static_cast<Axis>(base);
    entry.level = 1;
    entry.sigma = FrfSigma{.relative = 0.015, .floor = 0.01};
    test.data.frf.push_back(entry);
    FrfSet set;
    set.quantity = FrfQuantity::transmissibility;
    set.hertz = VectorXd::LinSpaced(3000, 0.5 * modes.hertz(0), 400);
    set.references = {std::string("base.") + axis_word(base)};
    set.H.emplace_back(set.hertz.size(), 4);
    for (const std::string sensor : {"tip", "mid"})
      for (int axis : {1, 2}) {
        set.H[0].col(Index(set.responses.size())) =
            response(predict, VectorXd(), sensor, base, axis, set.hertz);
        set.responses.push_back(sensor + "." + axis_word(axis));
      }
    test.responses.push_back({set});
  }
  return test;
}

// Mass, frequency, rocking, spread, how far beside: most of fifteen numbers in intervals of 90 %.
TEST(FixtureBeside, is_named_with_how_far_beside_it_lies) {
  const Nominal nominal = nominal_of(slender(), Measured());
  const Hypothesis h = fixture(nominal, "beside in z");
  DiagnosisSettings settings;
  settings.plan_next = false;
  int held = 0;
  for (const std::array<double, 5>& truth : {std::array{2.5, 90., 1.5, 1.3, 0.03},
                                             {1.5, 90., 1.5, 1.3, 0.06},
                                             {2., 130., 1.2, 1.6, 0.05}}) {
    const VectorXd values = VectorXd::Map(truth.data(), 5);
    const Diagnosis d = diagnose(slender(), sweeps_of(on_fixture(slender(), h, values)), settings);
    ASSERT_FALSE(d.effects.empty()) << d.headline;
    const NamedEffect& named = d.effects.front();
    EXPECT_EQ(named.name, "fixture_flexibility") << d.headline;
    ASSERT_EQ(named.way, "beside in z") << d.headline;
    ASSERT_EQ(named.parameters.size(), 5u);
    EXPECT_LT(d.gap.after, 0.1 * d.gap.before) << d.gap.before;
    for (std::size_t k = 0; k < 5; ++k) {
      const auto& [low, high] = named.parameters[k].interval;
      if (low <= truth[k] && truth[k] <= high) ++held;
    }
  }
  EXPECT_GE(held, 12);
}

} // namespace
} // namespace plica::fixture_beside

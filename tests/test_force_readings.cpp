// Responses to forces as readings of a diagnosis, held against chains of masses in closed form.
#include "diagnose/diagnose.hpp"
#include "diagnose/predict/predictor.hpp"
#include "diagnose/readings/readings.hpp"
#include "diagnose/readings/same_thing.hpp"
#include "io/input/case_file.hpp"
#include "io/input/measured_file.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const std::string frame_folder = PLICA_SOURCE_DIR "/cases/three_storey_frame/";
constexpr double frame_damping = 0.002; // as the case says

// Three floors on legs, in x: k = 12 EI / h^3 between neighbours, the first to the ground.
struct Chain {
  Vector3d mass = Vector3d::Constant(5.201);
  Vector3d stiffness = Vector3d::Constant(12 * 15.75 / std::pow(0.1533, 3));

  // Accelerances of the floors to a force on one, per line.
  Eigen::MatrixXcd accelerance(int driven, const Eigen::VectorXd& hertz) const {
    Matrix3d K = stiffness.asDiagonal();
    for (int i = 0; i < 2; ++i) {
      K(i, i) += stiffness[i + 1];
      K(i, i + 1) = K(i + 1, i) = -stiffness[i + 1];
    }
    const Matrix3d M = mass.asDiagonal();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix3d> modes(K, M);
    Eigen::MatrixXcd H = Eigen::MatrixXcd::Zero(hertz.size(), 3);
    for (Eigen::Index k = 0; k < hertz.size(); ++k)
      for (int r = 0; r < 3; ++r) {
        const double w = 2 * std::numbers::pi * hertz[k], lambda = modes.eigenvalues()[r];
        const std::complex<double> under(lambda - w * w, 2 * frame_damping * std::sqrt(lambda) * w);
        const Vector3d phi = modes.eigenvectors().col(r);
        H.row(k) += (-w * w * phi[driven] / under * phi.cast<std::complex<double>>()).transpose();
      }
    return H;
  }
};

const std::vector<std::string> floors{"floor1.x", "floor2.x", "floor3.x"};

// A test of a chain in a state: forces on the given floors, one entry each.
void add_test(TestData& test, const Chain& chain, const std::vector<int>& driven,
              const std::string& state, double level = 0) {
  const Eigen::VectorXd hertz = Eigen::VectorXd::LinSpaced(8001, 2, 42);
  for (int at : driven) {
    MeasuredFrf entry;
    entry.file = "none";
    entry.force = floors[std::size_t(at)];
    entry.state = state;
    if (level > 0) entry.level = level;
    test.data.frf.push_back(entry);
    FrfSet set;
    set.hertz = hertz;
    set.responses = floors;
    set.references = {entry.force};
    set.H = {chain.accelerance(at, hertz)};
    test.responses.push_back({set});
  }
}

TestData nothing_measured() {
  TestData test;
  test.data = read_measured(frame_folder + "measured.yaml");
  test.data.modes.clear();
  return test;
}

std::vector<MeasuredState> before_and_after() {
  MeasuredState before, after;
  before.name = "before";
  before.baseline = true;
  after.name = "after";
  return {before, after};
}

TEST(ForceReadings, the_nominal_case_answers_as_the_chain_does) {
  const CaseFile file = read_case(frame_folder + "three_storey_frame.yaml");
  TestData test = nothing_measured();
  add_test(test, Chain{}, {0, 1, 2}, "");
  const TestReadings readings = readings_of(test);
  ASSERT_EQ(readings.runs.size(), 3u);
  for (const TestRun& run : readings.runs) EXPECT_EQ(run.peaks.size(), 3u) << run.input.force;
  ASSERT_EQ(readings.readings.size(), 3u * 3 * 5) << "of each peak three, two shares";
  const Nominal nominal = nominal_of(file.data, test.data);
  const auto y = Predictor(nominal, readings, {})(Eigen::VectorXd());
  ASSERT_TRUE(y);
  for (std::size_t i = 0; i < readings.readings.size(); ++i) {
    const Reading& r = readings.readings[i];
    const double tolerance = r.kind == ReadingKind::frequency ? 1e-4
                             : r.kind == ReadingKind::damping ? 1e-2
                                                              : 1e-2;
    EXPECT_NEAR((*y)[Eigen::Index(i)], r.log_value, tolerance) << r.name;
  }
}

// Quantities that are no accelerations become such.
TEST(ForceReadings, a_mobility_reads_as_the_accelerance_it_stands_for) {
  TestData test = nothing_measured(), other = test;
  add_test(test, Chain{}, {0}, "");
  other = test;
  FrfSet& set = other.responses[0][0];
  set.quantity = FrfQuantity::mobility;
  for (Eigen::Index k = 0; k < set.hertz.size(); ++k)
    set.H[0].row(k) /= std::complex<double>(0, 2 * std::numbers::pi * set.hertz[k]);
  const TestReadings a = readings_of(test), b = readings_of(other);
  ASSERT_EQ(a.readings.size(), b.readings.size());
  for (std::size_t i = 0; i < a.readings.size(); ++i)
    EXPECT_NEAR(a.readings[i].log_value, b.readings[i].log_value, 1e-9) << a.readings[i].name;
}

// A mode that three forces show is one thing, in a changed state, too; three modes are three.
TEST(ForceReadings, forces_share_the_modes_that_they_show) {
  TestData test = nothing_measured();
  test.data.states = before_and_after();
  Chain changed;
  changed.mass[1] *= 1.2;
  add_test(test, Chain{}, {0, 1, 2}, "before");
  add_test(test, changed, {0, 2}, "after");
  const TestReadings readings = readings_of(test);
  std::set<int> modes;
  for (const Reading& a : readings.readings) {
    if (a.kind != ReadingKind::frequency) continue;
    modes.insert(a.mode);
    for (const Reading& b : readings.readings)
      if (b.kind == ReadingKind::frequency) {
        const bool near = std::abs(std::log(a.value / b.value)) < 0.15;
        EXPECT_EQ(same_thing(readings, a, b), near) << a.name << "; " << b.name;
      }
  }
  EXPECT_EQ(modes.size(), 3u);
}

// What the other codes of the house do not share: the change was made in the chain.
TEST(ForceReadings, a_mass_on_a_floor_is_found_from_responses_to_forces_alone) {
  const CaseFile file = read_case(frame_folder + "three_storey_frame.yaml");
  TestData test = nothing_measured();
  test.data.states = before_and_after();
  Chain built, changed;
  built.stiffness *= 0.85; // no model is as built
  changed = built;
  changed.mass[1] += 0.6;
  add_test(test, built, {0, 2}, "before");
  add_test(test, changed, {0, 2}, "after");
  const Diagnosis d = diagnose(file.data, test, {});
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const auto holds = [](const auto& effect) {
    return effect.name.find("mass") != std::string::npos && effect.place.find("floor2") == 0;
  };
  EXPECT_TRUE(holds(d.effects.front()) || d.effects.front().place == "sensor.floor2")
      << d.headline << ": " << d.effects.front().name << " at " << d.effects.front().place;
}

TEST(ForceReadings, a_level_of_a_force_is_in_newtons) {
  TestData test = nothing_measured();
  add_test(test, Chain{}, {0}, "", 2.5);
  const TestReadings readings = readings_of(test);
  ASSERT_FALSE(readings.runs.empty());
  EXPECT_TRUE(readings.runs[0].by_force);
  EXPECT_NE(readings.readings[0].name.find("force at floor1.x, 2.5 N"), std::string::npos)
      << readings.readings[0].name;
}

} // namespace
} // namespace plica

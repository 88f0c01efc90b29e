// What the table holds of a specimen, and what a diagnosis makes of it: sensors on held ends,
// mounts of springs.
#include "diagnose/diagnose.hpp"
#include "diagnose/effects/on_table.hpp"
#include "diagnose/weigh/damping_weights.hpp"
#include "diagnose/weigh/scatter.hpp"
#include "diagnose/weigh/uncertainty.hpp"
#include "run/results/normal_distribution.hpp"
#include "tests/changed_beam.hpp"
#include "tests/tube_case.hpp"
#include "words/directions.hpp"
#include "words/input_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::array levels{1., 3., 10.};

// A beam held at one end, in two pieces with a lap between; sensors at its tip and where it is
// held.
Case lapped_beam() {
  Case c;
  c.name = "lapped_beam";
  c.materials["aluminium"] = {.E = 70e9, .nu = 0.33, .rho = 2700};
  const auto piece = [&](const std::string& name, double from, double to) {
    BeamPart beam;
    beam.points = {{0, from, 0}, {0, to, 0}};
    beam.elements = 6;
    beam.up = {0, 0, 1};
    beam.section.shape = BeamShape::rectangle;
    beam.section.material = "aluminium";
    beam.section.width = 0.03;
    beam.section.depth = 0.01;
    c.parts.push_back({name, beam});
  };
  piece("first", 0, 0.3);
  piece("second", 0.3, 0.6);
  Cap root, lap;
  root.name = "root";
  root.of = {"first.start"};
  lap.name = "lap";
  lap.of = {"first.end", "second.start"};
  lap.stiffness = Sextuple{5e7, 5e7, 5e7, 2e4, 2e4, 2e4};
  c.caps = {root, lap};
  c.mount.push_back({.cap = "root"});
  for (const auto& [name, y] : {std::pair{"tip", 0.6}, {"root", 0.}}) {
    Sensor s;
    s.name = name;
    s.at = {0, y, 0};
    c.sensors.push_back(s);
  }
  c.analyses.damping.modal = 0.01;
  return c;
}

// The lap and a mount of springs with a loss factor, stated for them or at the springs; as dashpots
// c = tau k the loss of each mode is tau omega in place of eta.
TEST(DiagnosisOfDampedSprings, damps_each_mode_by_what_its_springs_lose) {
  constexpr double eta = 0.3, tau = 2e-4;
  Case plain = lapped_beam();
  plain.mount[0].kind = MountKind::springs;
  plain.mount[0].stiffness = {2e6, 2e6, 2e6, 2e3, 2e3, 2e3};
  plain.analyses.damping.modal = 0;
  Case stated = plain, springs = plain, dashpots = plain, varying = plain;
  stated.analyses.damping.loss_factors = {{"caps.lap", eta}, {"mount.root", eta}};
  springs.caps[1].damping.emplace().loss_factor = eta;
  springs.mount[0].damping = springs.caps[1].damping;
  const auto dashpot = [&](const Sextuple& k) {
    SpringDamping d;
    d.dashpot.emplace();
    for (std::size_t i = 0; i < 6; ++i) (*d.dashpot)[i] = tau * k[i];
    return d;
  };
  dashpots.caps[1].damping = dashpot(*plain.caps[1].stiffness);
  dashpots.mount[0].damping = dashpot(plain.mount[0].stiffness);
  const Measured none;
  const Nominal a = nominal_of(stated, none), b = nominal_of(springs, none),
                c = nominal_of(dashpots, none);
  const VectorXd &zeta = a.states[0].zeta, omega = a.states[0].model->lambda().cwiseSqrt();
  ASSERT_GT(zeta.minCoeff(), 0);
  for (Index j = 0; j < zeta.size(); ++j) {
    EXPECT_NEAR(b.states[0].zeta[j] / zeta[j], 1, 1e-6) << j;
    EXPECT_NEAR(c.states[0].zeta[j] / zeta[j], tau * omega[j] / eta, 1e-6 * tau * omega[j] / eta)
        << j;
  }
  varying.mount[0].damping.emplace().springpot = Springpot{1e-3, 0.5};
  try {
    nominal_of(varying, none);
    ADD_FAILURE() << "a stiffness over frequency was taken";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().at(0).key, "mount.root.damping");
  }
}

// Sweeps along x and z at three levels, as the model of the case has them with the damping that
// each direction has.
TestData sweeps_of(Case truth, double along_x, double along_z) {
  TestData test;
  test.data.specimen = truth.name;
  for (int base : {0, 2}) {
    truth.analyses.damping.modal = base == 0 ? along_x : along_z;
    const Nominal model = nominal_of(truth, test.data);
    const TestReadings none;
    const Predictor predict(model, none, {});
    const AffineModes modes = *predict.modes(VectorXd());
    for (double level : levels) {
      MeasuredFrf entry;
      entry.base = static_cast<Axis>(base);
      entry.level = level;
      entry.sigma = FrfSigma{.relative = 0.015, .floor = 0.01};
      test.data.frf.push_back(entry);
      FrfSet set;
      set.quantity = FrfQuantity::transmissibility;
      Index first = 0;
      modes.gamma.col(base).cwiseAbs().maxCoeff(&first);
      set.hertz = VectorXd::LinSpaced(1500, 0.7 * modes.hertz(first), 1.4 * modes.hertz(first));
      set.references = {std::string("base.") + axis_word(base)};
      set.H.emplace_back(set.hertz.size(), 4);
      for (const std::string sensor : {"tip", "root"})
        for (int axis : {0, 2}) {
          TestRun run{.state = "",
                      .input = {.base = base, .force = ""},
                      .sensor = sensor,
                      .axis = axis,
                      .peaks = {}};
          set.H[0].col(Index(set.responses.size())) = *predict.response(VectorXd(), run, set.hertz);
          set.responses.push_back(sensor + "." + axis_word(axis));
        }
      test.responses.push_back({set});
    }
  }
  return test;
}

// A fifth more damping in one mode and a fifth less in another is what admissible specimens have.
// The sensor at the root reads 1 whatever the damping.
TEST(HeldEnds, a_sensor_there_makes_no_effect_of_the_scatter_of_damping) {
  const Case data = lapped_beam();
  DiagnosisSettings settings;
  settings.plan_next = false;
  const Diagnosis d = diagnose(data, sweeps_of(data, 0.012, 0.008), settings);
  EXPECT_EQ(d.verdict, Verdict::none) << d.headline;
  EXPECT_LT(d.gap.before, 1);
}

// The numbers that the report says are those that weigh.
TEST(HeldEnds, damping_left_free_is_weighed_by_what_is_said_of_its_scatter) {
  const Case data = lapped_beam();
  DiagnosisSettings settings;
  settings.plan_next = false;
  const Diagnosis d = diagnose(data, sweeps_of(data, 0.02, 0.02), settings);
  EXPECT_EQ(d.verdict, Verdict::identified) << d.headline;
  const auto free = std::find_if(d.compensators.begin(), d.compensators.end(),
                                 [](const Compensator& c) { return c.name == "all damping"; });
  ASSERT_NE(free, d.compensators.end());
  EXPECT_NEAR(free->prior_sigmas, std::log(free->factor) / scatters::all_damping, 1e-9);
  EXPECT_EQ(scatters::all_damping, 0.08);
  EXPECT_TRUE(std::any_of(d.assumptions.begin(), d.assumptions.end(), [](const std::string& a) {
    return a.find("damping 8 % of all modes alike and 12 % of each") != std::string::npos;
  }));
}

// An even distribution over a fifth either way: the logarithm's standard deviation is about 0.11.
TEST(HeldEnds, a_tolerance_of_damping_is_how_far_all_damping_scatters) {
  Case data = lapped_beam();
  const double modal = data.analyses.damping.modal;
  EXPECT_EQ(scatters::all_damping_of(data), 0.08);
  data.tolerances.push_back({"analyses.damping.modal", modal, 0.8 * modal, 1.2 * modal, false});
  EXPECT_NEAR(scatters::all_damping_of(data), std::log(1.18 / 0.82) / (2 * normal_quantile(0.95)),
              1e-9);
  DiagnosisSettings settings;
  settings.plan_next = false;
  const Diagnosis d = diagnose(data, sweeps_of(data, 0.012, 0.012), settings);
  const auto says = [&](const std::string& words) {
    return std::any_of(d.assumptions.begin(), d.assumptions.end(),
                       [&](const std::string& a) { return a.find(words) != std::string::npos; });
  };
  EXPECT_TRUE(says("damping 11 % of all modes alike"));
  EXPECT_EQ(d.verdict, Verdict::none) << d.headline;
}

// The height of the tip's peak falls as damping rises, the root's reading stays.
TEST(HeldEnds, readings_answer_to_damping_as_the_model_says) {
  const Case data = lapped_beam();
  const TestData test = sweeps_of(data, 0.01, 0.01);
  const TestReadings readings = readings_of(test);
  const Nominal nominal = nominal_of(data, test.data);
  const VectorXd felt = damping_weights(nominal, readings).rowwise().sum();
  int tips = 0, roots = 0;
  for (Index i = 0; i < felt.size(); ++i) {
    const Reading& r = readings.readings[std::size_t(i)];
    const bool tip = r.sensor == "tip", height = r.kind == ReadingKind::amplitude;
    const double expected = r.kind == ReadingKind::damping ? 1 : height && tip ? -1 : 0;
    if (r.kind != ReadingKind::cross) {
      EXPECT_NEAR(felt[i], expected, expected < 0 ? 0.02 : 1e-9) << r.name;
    }
    tips += height && tip;
    roots += height && !tip;
  }
  EXPECT_EQ(tips, 6);
  EXPECT_EQ(roots, 6);
}

// A section that stands askew moves across the table, too, by c / zeta of the mode that resonates
// there. In terms of its height where the table drives it, which has the same zeta, that is the
// tangent of how far askew it stands: modes of unlike damping do not make it more.
TEST(CrossReadings, at_a_resonance_do_not_answer_to_its_damping) {
  constexpr double askew = 0.05;
  Case data = lapped_beam();
  for (Part& part : data.parts) {
    auto& beam = std::get<BeamPart>(part.body);
    beam.up = {askew, 0, 1};
    beam.section.depth = 0.025;
  }
  const TestData test = sweeps_of(data, 0.01, 0.01);
  const TestReadings readings = readings_of(test);
  const Nominal nominal = nominal_of(data, test.data);
  const Eigen::MatrixXd W = damping_weights(nominal, readings);
  int heights = 0, resonances = 0;
  for (Index i = 0; i < W.rows(); ++i) {
    const Reading& r = readings.readings[std::size_t(i)];
    if (r.kind == ReadingKind::amplitude && r.sensor == "tip") {
      ++heights;
      EXPECT_NEAR(W.row(i).minCoeff(), -1, 0.1) << r.name;
    } else if (r.kind == ReadingKind::cross && r.at_run >= 0) {
      ++resonances;
      EXPECT_NEAR(r.value, askew, 0.1 * askew) << r.name;
      EXPECT_LT(W.row(i).cwiseAbs().maxCoeff(), 0.02) << r.name;
    }
  }
  EXPECT_GT(heights, 0);
  EXPECT_GT(resonances, 0);
}

// Two ends that springs hold, stiff beside the tube between them.
Case spring_mounted(double stiffness) {
  Case data = test::tube(0.8);
  for (Cap& cap : data.caps) cap.mass = 1;
  data.mount[1].kind = MountKind::springs;
  const double k = stiffness, turning = 0.01 * stiffness;
  data.mount[1].stiffness = {k, k, k, turning, turning, turning};
  data.analyses.damping.modal = 0.01;
  data.sensors = {{.name = "mid", .at = {0, test::L / 2, 0}}};
  return data;
}

Measured static_test(double value) {
  Measured m;
  MeasuredStatic k;
  k.direction = StaticDirection::axial;
  k.value = value;
  k.sigma = 0.01 * value;
  m.statics.push_back(k);
  return m;
}

// The rig pulls at the caps: what a mount on the table has for springs is not in it, nor how well
// they are known.
TEST(SpringMounts, leave_a_static_test_its_value_and_its_uncertainty) {
  const auto reading = [](const Case& data) {
    const Measured measured = static_test(test::EA / test::L);
    const TestReadings test = readings_of({.data = measured, .responses = {}});
    const Nominal nominal = nominal_of(data, measured);
    const Uncertainty u = uncertainty_of(data, nominal, test, measured, {});
    return std::pair{std::exp(u.nominal[0] + u.bias[0]), std::sqrt(u.total()(0, 0))};
  };
  Case rigid = spring_mounted(1);
  rigid.mount[1] = {.cap = "right"};
  const auto [value, sigma] = reading(rigid);
  EXPECT_NEAR(value / (test::EA / test::L), 1, 0.01);
  for (double stiffness : {1e6, 1e9}) {
    const auto [own, own_sigma] = reading(spring_mounted(stiffness));
    EXPECT_NEAR(own / value, 1, 1e-3) << stiffness;
    EXPECT_NEAR(own_sigma / sigma, 1, 0.02) << stiffness;
  }
}

std::set<std::string> places_of(const std::string& effect, const Case& data) {
  const Measured none;
  const Nominal nominal = nominal_of(data, none);
  std::set<std::string> places;
  for (const Hypothesis& h : effect_named(effect).hypotheses(nominal.structure(none)))
    places.insert(h.place);
  return places;
}

TEST(SpringMounts, may_give_way_and_may_stand_on_a_fixture) {
  using Places = std::set<std::string>;
  Case data = spring_mounted(1e7);
  EXPECT_EQ(places_of("boundary_compliance", data), (Places{"mount.left", "mount.right"}));
  EXPECT_EQ(places_of("fixture_flexibility", data), (Places{"mount.left", "mount.right", "mount"}));
  EXPECT_EQ(places_of("joint_stiffness", data), Places{});
  data.mount[0] = data.mount[1];
  data.mount[0].cap = "left";
  EXPECT_EQ(places_of("boundary_compliance", data), (Places{"mount.left", "mount.right", "mount"}));
  EXPECT_EQ(places_of("fixture_flexibility", data), (Places{"mount.left", "mount.right", "mount"}));
}

// Mass, both static tests and the lowest modes of the model.
Measured modes_of(const Case& truth) {
  Measured m = static_test(1);
  m.statics.push_back(m.statics.front());
  m.statics.back().direction = StaticDirection::transverse_x;
  m.weighings = {{.value = 1, .sigma = 0.001, .repeats = {}}};
  for (const auto& [axis, order] :
       {std::pair{Axis::x, 1}, {Axis::x, 2}, {Axis::z, 1}, {Axis::z, 2}})
    m.modes.push_back(changed_beam::damped_mode(MeasuredShape::transverse, axis, order));
  m.modes.push_back(changed_beam::damped_mode(MeasuredShape::axial, Axis::y, 1));
  changed_beam::take_readings(m, changed_beam::read_by(truth, m));
  for (MeasuredStatic& k : m.statics) k.sigma = 0.015 * k.value;
  return m;
}

TEST(SpringMounts, a_softer_one_is_named_with_its_ratio) {
  constexpr double k = 2e7, ratio = 0.2;
  Case truth = spring_mounted(k);
  for (double& own : truth.mount[1].stiffness) own *= ratio;
  DiagnosisSettings settings;
  settings.plan_next = false;
  const Diagnosis d =
      diagnose(spring_mounted(k), {.data = modes_of(truth), .responses = {}}, settings);
  // Without levels slip of the mount looks alike.
  const auto own = std::find_if(d.effects.begin(), d.effects.end(), [](const NamedEffect& e) {
    return e.name == "boundary_compliance" && e.place == "mount.right";
  });
  ASSERT_NE(own, d.effects.end()) << d.headline;
  EXPECT_EQ(own->parameters.front().name, "ratio");
  EXPECT_LE(own->parameters.front().interval[0], ratio);
  EXPECT_GE(own->parameters.front().interval[1], ratio);
  EXPECT_GT(d.gap.shrink(), 0.8);
}

TEST(SpringMounts, effects_without_a_place_are_said) {
  Case data = lapped_beam();
  DiagnosisSettings settings;
  settings.plan_next = false;
  const Diagnosis d = diagnose(data, sweeps_of(data, 0.01, 0.01), settings);
  const auto needs = [&](const std::string& effect) {
    for (const EffectNotTried& e : d.not_tried)
      if (e.name == effect) return e.needs;
    return std::string();
  };
  EXPECT_EQ(needs("ply_slip"), "a bellows");
  EXPECT_EQ(needs("boundary_compliance"), "");
}

} // namespace
} // namespace plica

// Where things touch or sit: along pipes and chains, on crowns.
#include "diagnose/effects/beam_path.hpp"
#include "io/input/case_file.hpp"
#include "run/routes/route.hpp"
#include "solve/modes.hpp"
#include "tests/bellows_case.hpp"
#include "tests/changed_beam.hpp"
#include "tests/moving_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace plica {
namespace {

using namespace changed_beam;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

EquivalentPipe pipe_of(double start, double length, double of_length) {
  EquivalentPipe p;
  p.material = "steel";
  p.start = start;
  p.length = p.convoluted = length;
  p.outer = {.radius = 0.05,
             .wall = 0.001,
             .axial = 5e4 * of_length / length,
             .torsion = 2e5 * of_length / length};
  p.end_radius = 0.05;
  p.end_wall = 0.0005;
  p.elements = 40;
  return p;
}

Case empty_case() {
  Case c;
  c.name = "pipe";
  c.materials["steel"] = {.E = 193e9, .nu = 0.3, .rho = 8000};
  c.analyses.modes = Modes{.count = 8};
  c.analyses.damping.modal = 0.01;
  return c;
}

void hold_ends(Case& c, const std::string& left, const std::string& right) {
  c.caps.push_back({.name = "left", .of = {left}});
  c.caps.push_back({.name = "right", .of = {right}});
  c.mount.push_back({.cap = "left"});
  c.mount.push_back({.cap = "right"});
}

Case held_at_both_ends(const std::variant<EquivalentPipe, ConnectorChain>& body) {
  Case c = empty_case();
  std::visit([&](const auto& own) { c.parts.push_back({"pipe", own}); }, body);
  hold_ends(c, "pipe.left", "pipe.right");
  return c;
}

ConnectorChain chain_with_arms() {
  ConnectorChain chain;
  chain.start = 0.1;
  chain.length = 0.5;
  chain.arms = 0.03;
  chain.count = 20;
  chain.spring = {.axial = 1e6, .transverse = 1e6, .bending = 500, .torsion = 1e3};
  chain.mass = 1;
  chain.radius = 0.05;
  return chain;
}

// Of 27 convolutions a dent may be in any.
TEST(ContactPlaces, a_dent_may_be_in_every_convolution) {
  const Case data = read_case(PLICA_SOURCE_DIR "/cases/bellow_a2/bellow_a2.yaml", "one_wall").data;
  const BuiltCase built = build(data);
  const Measured m;
  std::set<int> places;
  const std::string head = "bellows.convolution[";
  for (const Hypothesis& h :
       local_damage().hypotheses({.data = data, .built = built, .measured = m}))
    if (h.place.starts_with(head)) places.insert(std::stoi(h.place.substr(head.size())));
  EXPECT_EQ(places.size(), 27U);
  EXPECT_EQ(*places.begin(), 1);
  EXPECT_EQ(*places.rbegin(), 27);
}

// A mesh that moves along z as the cubic w(y), sections turning with it, does so anywhere: exactly,
// since Hermite's cubics hold w.
TEST(ContactPlaces, a_spring_anywhere_along_a_pipe_or_chain_feels_a_cubic_as_it_is) {
  EquivalentPipe with_ends = pipe_of(0.1, 0.5, 0.5);
  with_ends.convoluted = 0.4;
  const auto w = [](double y) { return 1 + 2 * y - 30 * y * y + 40 * y * y * y; };
  const auto slope = [](double y) { return 2 - 60 * y + 120 * y * y; };
  Measured m;
  for (const Case& c : {held_at_both_ends(with_ends), held_at_both_ends(chain_with_arms())}) {
    const BuiltCase built = build(c);
    const Structure s{.data = c, .built = built, .measured = m};
    const std::vector<BeamPath> paths = line_paths(s);
    ASSERT_EQ(paths.size(), 1U);
    EXPECT_TRUE(beam_paths(s).empty());
    const BeamPath& path = paths.front();
    EXPECT_NEAR(path.length(), 0.5, 1e-12);
    EXPECT_LE(path.nodes.size(), 21U);
    const MovingMotion motion = motion_along(s, path, Vector3d::UnitZ(), MotionTerm::Of::spring);
    EXPECT_TRUE(motion.terms.front().term->begins);
    for (double at : {0., 0.013, 0.1, 0.237, 0.44, 0.499, 0.5}) {
      const double moved = motion_of(motion, VectorXd::Constant(1, at), [&](int node, int dof) {
        const double y = built.model.mesh.nodes[std::size_t(node)].y();
        return dof == 2 ? w(y) : dof == 3 ? slope(y) : 0;
      });
      EXPECT_NEAR(moved, w(0.1 + at), 1e-9) << at;
    }
  }
}

// A place of the case and a sensor off the even steps are nodes more; the path has its length all
// the same, and damage of a stretch takes the elements that lie in it.
TEST(ContactPlaces, a_beam_with_nodes_off_its_even_steps_has_a_path_and_its_stretches) {
  Case c = beam_of(2, 0.6, 0.03, 0.006, true);
  std::get<BeamPart>(c.parts[0].body).places = {{"hanger", {0, 0.11, 0}}};
  const BuiltCase built = build(c);
  const Measured m;
  const Structure s{.data = c, .built = built, .measured = m, .stiffness = 1e4, .mass = 1};
  ASSERT_EQ(built.model.beams.size(), 13U);
  ASSERT_EQ(beam_paths(s).size(), 1U);
  EXPECT_NEAR(beam_paths(s).front().length(), 0.6, 1e-12);
  std::vector<std::size_t> changed;
  for (const Hypothesis& h : effect_named("local_damage").hypotheses(s)) {
    if (!h.place.starts_with("beam.stretch[")) continue;
    Model model = built.model;
    h.changes.front().apply(model);
    std::size_t count = 0;
    for (std::size_t i = 0; i < model.beams.size(); ++i)
      if (model.beams[i].section.EI_y != built.model.beams[i].section.EI_y) ++count;
    changed.push_back(count);
  }
  EXPECT_EQ(changed, (std::vector<std::size_t>{7, 6}));
}

// Of 16 convolutions all are looked at first, of 17 to 32 every other one lies next to one of
// these; between two the shares say how far along.
TEST(ContactPlaces, every_convolution_is_a_place) {
  EXPECT_EQ(stations_of(16, 16).size(), 16U);
  for (int count : {1, 7, 16, 17, 27, 32, 40}) {
    const std::vector<ConvolutionPlace> all = convolution_places("bellows", count);
    ASSERT_EQ(all.size(), std::size_t(count));
    std::map<std::string, int> first;
    std::set<int> numbers;
    for (const ConvolutionPlace& c : all) {
      EXPECT_EQ(c.place, "bellows.convolution[" + std::to_string(c.number) + "]");
      EXPECT_TRUE(numbers.insert(c.number).second) << c.number;
      if (c.between.empty()) {
        EXPECT_EQ(first.size(), numbers.size() - 1) << "those that are looked at come first";
        first[c.place] = c.number;
        continue;
      }
      double sum = 0, along = 0;
      int nearest = count;
      for (const auto& [place, share] : c.between) {
        sum += share;
        along += share * first.at(place);
        nearest = std::min(nearest, std::abs(first.at(place) - c.number));
      }
      EXPECT_NEAR(sum, 1, 1e-12);
      if (c.between.size() == 2) {
        EXPECT_NEAR(along, c.number, 1e-12);
      }
      if (count <= 32) {
        EXPECT_EQ(nearest, 1) << c.number << " of " << count;
      }
    }
    EXPECT_EQ(first.size(), std::size_t(std::min(count, 16)));
    EXPECT_EQ(*numbers.begin(), 1);
    EXPECT_EQ(*numbers.rbegin(), count);
  }
}

// Frequencies of a bellows that something touches at a crown, from a touch to a pin, against those
// of its whole mesh with the same springs.
TEST(ContactPlaces, a_support_on_a_crown_is_followed_to_a_pin) {
  Case c = test::verification_case("bellows_a", {.around = 16, .arc = 2, .wall = 2});
  const Nominal nominal = nominal_of(c, Measured());
  const BuiltCase built = build(c);
  const Model& whole = built.model;
  const auto first = [&](const Model& model) {
    const System system = assemble(model);
    const std::vector<int> free =
        complement(system.map.size(), node_dofs(system.map, built.held_nodes));
    const SparseMatrix K = restrict_to(system.K, free), M = restrict_to(system.M, free);
    BaseFactor base = factor_below_spectrum(K, M);
    return VectorXd(find_modes(K, M, {.count = 6, .band = {}, .proof = true}, base).lambda.head(6));
  };
  const VectorXd free = first(whole);
  int ways = 0;
  for (const Hypothesis& h :
       effect_named("extra_support").hypotheses(nominal.structure(Measured()))) {
    if (h.place != "bellows.convolution[4]" || h.way == "on the mean motion") continue;
    ++ways;
    for (double share : {0.01, 1., 100., 1e4}) {
      const double k = share * nominal.stiffness;
      Model held = whole;
      h.changes[0].apply(held);
      for (std::size_t b = whole.bushings.size(); b < held.bushings.size(); ++b)
        held.bushings[b].bushing.law *= k;
      const VectorXd expected = first(held);
      const TestReadings none;
      const AffineModes found = *Predictor(nominal, none, {&h}).modes(VectorXd::Constant(1, k));
      for (Index i = 0; i < 6; ++i)
        EXPECT_NEAR(std::sqrt(found.lambda[i] / expected[i]), 1, 0.01)
            << h.way << ", " << share << " of its own, mode " << i + 1 << ": "
            << std::sqrt(expected[i] / free[i]);
    }
  }
  EXPECT_EQ(ways, 4) << "x, y, z and all round";
}

// Ten convolutions of 6 mm: the fourth crown 21 mm along, which its mirror image answers alike.
TEST(ContactPlaces, a_mass_on_a_crown_has_its_place_in_metres) {
  Case c = test::verification_case("bellows_a", {.around = 16, .arc = 2, .wall = 2});
  c.diagnose.effects = {"added_mass"};
  Case truth = c;
  truth.parts.push_back({"clamp", PointMass{.at = "bellows.crown[4]", .mass = 0.02}});
  Measured m;
  m.specimen = "bellows";
  for (Axis axis : {Axis::x, Axis::z})
    for (int order = 1; order <= 4; ++order) m.modes.push_back(bending(axis, order, ""));
  take_readings(m, read_by(truth, m));
  const Diagnosis d = diagnosis_of(c, m);
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  ASSERT_TRUE(e.along) << e.place;
  EXPECT_TRUE(std::abs(e.along->value - 0.021) < 1e-3 || std::abs(e.along->value - 0.039) < 1e-3)
      << e.along->value << ": " << d.headline;
  EXPECT_LE(e.along->interval[0], e.along->value - 2.9e-3);
  EXPECT_GE(e.along->interval[1], e.along->value + 2.9e-3);
  EXPECT_LE(e.along->interval[1] - e.along->interval[0], 0.06) << "longer than the bellows";
}

// Bellows A with 27 convolutions, of which sixteen are looked at first; the ninth lies between two
// of these, and the nineteenth is its mirror image.
class LongBellowsSlow : public testing::Test {
protected:
  LongBellowsSlow() {
    test::bellows_of(nominal_).profile.front().count = 27;
    nominal_.diagnose.effects = {"added_mass", "local_damage"};
    m_.specimen = "bellows";
    for (Axis axis : {Axis::x, Axis::z})
      for (int order = 1; order <= 4; ++order) m_.modes.push_back(bending(axis, order, ""));
  }
  void expect_ninth(const std::string& effect) {
    for (MeasuredMode& mode : m_.modes) mode.sigma = 1e-3 * mode.frequency;
    const std::vector<ConvolutionPlace> all = convolution_places("bellows", 27);
    const auto ninth = std::find_if(all.begin(), all.end(),
                                    [](const ConvolutionPlace& c) { return c.number == 9; });
    EXPECT_FALSE(ninth->between.empty());
    const Diagnosis d = diagnosis_of(nominal_, m_);
    ASSERT_FALSE(d.effects.empty()) << d.headline;
    const NamedEffect& e = d.effects.front();
    EXPECT_EQ(e.name, effect) << d.headline;
    EXPECT_TRUE(e.place == "bellows.convolution[9]" || e.place == "bellows.convolution[19]")
        << d.headline;
    ASSERT_TRUE(e.along) << e.place;
    const auto holds = [&](double y) {
      return e.along->interval[0] < y && y < e.along->interval[1];
    };
    EXPECT_TRUE(holds(0.051) || holds(0.111)) << e.along->value;
  }

  Case nominal_ = test::verification_case("bellows_a", {.around = 16, .arc = 2, .wall = 2});
  Measured m_;
};

TEST_F(LongBellowsSlow, has_a_mass_on_any_crown) {
  Case truth = nominal_;
  truth.parts.push_back({"clamp", PointMass{.at = "bellows.crown[9]", .mass = 0.02}});
  take_readings(m_, read_by(truth, m_));
  expect_ninth("added_mass");
}

TEST_F(LongBellowsSlow, has_a_dent_in_any_convolution) {
  const Nominal model = nominal_of(nominal_, m_);
  const std::vector<Hypothesis> all = local_damage().hypotheses(model.structure(m_));
  const auto dent = std::find_if(all.begin(), all.end(), [](const Hypothesis& h) {
    return h.place == "bellows.convolution[9]" && h.way == "90 degrees";
  });
  ASSERT_NE(dent, all.end());
  const TestReadings readings = readings_of({.data = m_, .responses = {}});
  take_readings(m_, *Predictor(model, readings, {&*dent})(Eigen::VectorXd::Constant(1, 0.8)));
  expect_ninth("local_damage");
}

// The truth is made of two pipes that meet where a hanger holds them, on a node of their own.
TEST(ContactPlaces, a_hanger_between_the_nodes_of_a_pipe_is_found_within_its_interval) {
  const double L = 0.8, at = 0.2734, k = 4e4;
  Case truth = empty_case();
  truth.parts.push_back({"one", pipe_of(0, at, L)});
  truth.parts.push_back({"other", pipe_of(at, L - at, L)});
  hold_ends(truth, "one.left", "other.right");
  truth.caps.push_back({.name = "hanger", .of = {"one.right", "other.left"}});
  truth.mount.push_back(
      {.cap = "hanger", .kind = MountKind::springs, .stiffness = {0, 0, k, 0, 0, 0}});
  Measured m;
  m.specimen = "pipe";
  for (int order = 1; order <= 4; ++order) m.modes.push_back(bending(Axis::z, order, ""));
  for (int order = 1; order <= 2; ++order) m.modes.push_back(bending(Axis::x, order, ""));
  take_readings(m, read_by(truth, m));
  for (MeasuredMode& mode : m.modes) mode.sigma = 2e-3 * mode.frequency;
  const Diagnosis d = diagnosis_of(held_at_both_ends(pipe_of(0, L, L)), m);
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "extra_support") << d.headline;
  EXPECT_EQ(e.place, "pipe");
  EXPECT_EQ(e.way, "z");
  ASSERT_EQ(e.parameters.back().name, "at");
  const std::array<double, 2>& interval = e.parameters.back().interval;
  const auto holds = [&](double place) { return interval[0] <= place && place <= interval[1]; };
  EXPECT_TRUE(holds(at) || holds(L - at)) // either half answers alike
      << interval[0] << " to " << interval[1] << ": " << d.headline;
}

} // namespace
} // namespace plica

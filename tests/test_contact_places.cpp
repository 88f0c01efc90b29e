// Where things touch or sit: along pipes and chains, on crowns, on plates.
#include "diagnose/effects/beam_path.hpp"
#include "diagnose/effects/place_nodes.hpp"
#include "diagnose/effects/plate_places.hpp"
#include "reduction/parametric_model.hpp"
#include "tests/changed_beam.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

// At a place, of DOFs that are given.
template <class Given>
double motion_of(const MovingMotion& motion, const VectorXd& place, const Given& given) {
  const VectorXd factors = motion.factors(place);
  EXPECT_EQ(factors.size(), Index(motion.terms.size()));
  double moved = 0;
  for (std::size_t i = 0; i < motion.terms.size(); ++i)
    moved += factors[Index(i)] * given(motion.terms[i].term->node, motion.terms[i].term->dof);
  return moved;
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

// Of 16 crowns all, of 27 each or the next one; damage is looked for at eight of them.
TEST(ContactPlaces, every_convolution_lies_at_or_beside_a_place) {
  EXPECT_EQ(stations_of(16, 16).size(), 16U);
  for (int count : {17, 27, 32}) {
    const std::vector<int> chosen = stations_of(count, 16), damaged = stations_of(count);
    EXPECT_EQ(chosen.size(), 16U);
    const std::set<int> all(chosen.begin(), chosen.end());
    EXPECT_EQ(all.size(), 16U);
    EXPECT_TRUE(std::is_sorted(chosen.begin(), chosen.end()));
    EXPECT_TRUE(std::includes(chosen.begin(), chosen.end(), damaged.begin(), damaged.end()));
    for (int k = 1; k <= count; ++k)
      EXPECT_TRUE(all.contains(k - 1) || all.contains(k) || all.contains(k + 1)) << k;
  }
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

Case plate_case() {
  Case c = empty_case();
  c.name = "plate";
  Plate plate;
  plate.material = "steel";
  plate.corners = {{{0, 0, 0}, {0.3, 0, 0}, {0.3, 0.16, 0}, {0, 0.24, 0}}};
  plate.thickness = 3e-3;
  plate.elements = {12, 8};
  c.parts.push_back({"plate", plate});
  c.caps.push_back({.name = "clamp", .of = {"plate.edge4"}});
  c.mount.push_back({.cap = "clamp"});
  c.sensors.push_back({.name = "corner", .at = {0.3, 0, 0}, .mass = 4e-3});
  return c;
}

// A flat rectangle that moves along its normal by a polynomial that Adini's hold: all of degree
// three, and x^3 y and x y^3.
TEST(ContactPlaces, a_spring_anywhere_on_a_plate_feels_a_cubic_as_it_is) {
  Case c = plate_case();
  std::get<Plate>(c.parts[0].body).corners[3] = {0, 0.16, 0};
  std::get<Plate>(c.parts[0].body).elements = {14, 5};
  const BuiltCase built = build(c);
  const Measured m;
  const Structure s{.data = c, .built = built, .measured = m};
  const std::vector<PlateGrid> grids = plate_grids(s);
  ASSERT_EQ(grids.size(), 1U);
  EXPECT_EQ(grids[0].nodes.size(), 9U * 6U);
  const auto w = [](double x, double y) {
    return 1 + 2 * x - 3 * y + 20 * x * x - 30 * x * y + 10 * y * y + 100 * x * x * x -
           200 * y * y * y + 50 * x * x * y + 300 * x * x * x * y - 400 * x * y * y * y;
  };
  const auto along = [](double x, double y) {
    return 2 + 40 * x - 30 * y + 300 * x * x + 100 * x * y + 900 * x * x * y - 400 * y * y * y;
  };
  const auto across = [](double x, double y) {
    return -3 - 30 * x + 20 * y - 600 * y * y + 50 * x * x + 300 * x * x * x - 1200 * x * y * y;
  };
  const MovingMotion motion = motion_on(s, grids[0], std::nullopt, MotionTerm::Of::spring);
  for (double x : {0., 0.011, 0.15, 0.293, 0.3})
    for (double y : {0., 0.07, 0.159, 0.16}) {
      const double moved = motion_of(motion, Eigen::Vector2d(x, y), [&](int node, int dof) {
        const Vector3d& at = built.model.mesh.nodes[std::size_t(node)];
        return dof == 2   ? w(at.x(), at.y())
               : dof == 3 ? across(at.x(), at.y())
               : dof == 4 ? -along(at.x(), at.y())
                          : 0;
      });
      EXPECT_NEAR(moved, w(x, y), 1e-10) << x << ", " << y;
    }
}

// Of the mesh with something at a node, solved whole.
VectorXd whole_with(const BuiltCase& built, int node, MotionTerm::Of of, double size, int count) {
  System system = assemble(built.model);
  const int dof = system.map.independent[std::size_t(6 * node + 2)];
  (of == MotionTerm::Of::spring ? system.K : system.M).coeffRef(dof, dof) += size;
  std::vector<int> inside;
  for (int i = 0; i < system.map.size(); ++i)
    if (system.map.full[std::size_t(i)] / 6 != built.held_nodes[0]) inside.push_back(i);
  const SparseMatrix K = restrict_to(system.K, inside), M = restrict_to(system.M, inside);
  BaseFactor base = factor_below_spectrum(K, M);
  return find_modes(K, M, {.count = count, .band = {}, .proof = true}, base).lambda.head(count);
}

// A touch, a mass of 3 % of the plate's, a pin, a mass of a third of it: at a node between those of
// the grid, so that no static answer at it is in the basis.
TEST(ContactPlaces, anywhere_on_a_plate_answers_as_the_mesh_does_at_its_nodes) {
  Case c = plate_case();
  std::get<Plate>(c.parts[0].body).elements = {24, 16};
  const BuiltCase built = build(c);
  const Measured m;
  const Structure s{.data = c, .built = built, .measured = m};
  const PlateGrid grid = plate_grids(s).front();
  const ParametricModel model(built.model, built.held_nodes, {built.sensors[0].node}, 20);
  constexpr int watched = 5;
  struct Put {
    MotionTerm::Of of;
    double size, tolerance;
  };
  using enum MotionTerm::Of;
  for (const auto& [i, j] : {std::pair{14, 6}, {22, 16}, {19, 7}}) {
    const int node = built.model.mesh.sets.at("plate.all")[std::size_t(25 * j + i)];
    const Eigen::Vector2d place(i / 24. * grid.length[0], j / 16. * grid.length[1]);
    for (const Put& put :
         {Put{spring, 1e3, 2e-4}, {mass, 0.05, 1e-3}, {spring, 1e8, 1.3e-2}, {mass, 0.5, 1e-2}}) {
      const MovingMotion motion = motion_on(s, grid, std::nullopt, put.of);
      const AffineModel affine = model.with(model.prepare(motion.terms));
      std::vector<int> free;
      for (int k = affine.boundary; k < int(affine.K.rows()); ++k) free.push_back(k);
      const AffineModel held = affine.restricted_to(free);
      const VectorXd x = std::sqrt(put.size) * motion.factors(place);
      const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> got(held.stiffness(x),
                                                                   held.mass_matrix(x));
      const VectorXd want = whole_with(built, node, put.of, put.size, watched);
      for (Index k = 0; k < watched; ++k)
        EXPECT_NEAR(std::sqrt(got.eigenvalues()[k] / want[k]), 1, put.tolerance)
            << put.size << " at " << place.transpose() << ", mode " << k + 1;
    }
  }
}

TEST(ContactPlaces, a_plate_has_spots_named_by_percents_of_its_edges_where_a_case_asks_for_them) {
  Case c = plate_case();
  const Measured m;
  const auto places_of = [&](const BuiltCase& built, const std::string& effect) {
    const Structure s{.data = c, .built = built, .measured = m, .stiffness = 1e4, .mass = 1};
    std::set<std::string> places;
    for (const Hypothesis& h : effect_named(effect).hypotheses(s)) places.insert(h.place);
    return places;
  };
  const BuiltCase built = build(c);
  EXPECT_EQ(places_of(built, "extra_support"), std::set<std::string>{"plate"});
  EXPECT_EQ(places_of(built, "added_mass"), (std::set<std::string>{"plate", "sensor.corner"}));
  c.diagnose.places = {"plate.spot"};
  const std::set<std::string> masses = places_of(built, "added_mass"),
                              supports = places_of(built, "extra_support");
  EXPECT_EQ(supports.size(), 21U); // the clamped edge has none
  EXPECT_EQ(masses.size(), 21U);   // one of them at the sensor
  EXPECT_FALSE(masses.contains("plate.spot[100][0]"));
  EXPECT_TRUE(supports.contains("plate.spot[100][0]"));
  const Structure s{.data = c, .built = built, .measured = m};
  const auto at = [&](const std::vector<int>& nodes) {
    EXPECT_EQ(nodes.size(), 1U);
    return built.model.mesh.nodes[std::size_t(nodes.front())];
  };
  const Vector3d middle(0.15, 0.05, 0); // the plate is 0.2 m wide there
  EXPECT_NEAR((at(nodes_at(s, "plate.spot[50][25]")) - middle).norm(), 0, 1e-12);
  EXPECT_NEAR((at(nodes_at(s, "plate", {0.15, 0.04})) - middle).norm(), 0, 1e-12);
}

// 0.15 kg on 1.44 kg of plate, at a node of the mesh: the first mode falls by 9 %, the third stays.
// Its place is told within intervals along either edge.
TEST(ContactPlaces, a_mass_on_a_plate_off_its_sensors_is_told_within_its_intervals) {
  Case nominal = plate_case();
  nominal.diagnose.model_error = 0.003;
  Case truth = nominal;
  truth.sensors.push_back({.name = "lump", .at = {0.225, 0.1125, 0}, .mass = 0.15});
  Measured m;
  m.specimen = "plate";
  for (int order = 1; order <= 7; ++order) {
    m.modes.push_back(bending(Axis::z, order, ""));
    m.modes.back().shape = MeasuredShape::other;
  }
  take_readings(m, read_by(truth, m));
  for (MeasuredMode& mode : m.modes) mode.sigma = 2e-3 * mode.frequency;
  const Diagnosis d = diagnosis_of(nominal, m);
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "added_mass") << d.headline;
  EXPECT_EQ(e.place, "plate");
  ASSERT_EQ(e.parameters.size(), 3U);
  const double share_across = 0.1125 / 0.18; // the plate is 0.18 m wide there
  const double there[] = {0.15, 0.225, share_across * 0.16};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LE(e.parameters[i].interval[0], there[i]) << e.parameters[i].name << ": " << d.headline;
    EXPECT_GE(e.parameters[i].interval[1], there[i]) << e.parameters[i].name << ": " << d.headline;
  }
  EXPECT_LT(e.parameters[1].interval[1] - e.parameters[1].interval[0], 0.1) << d.headline;
}

} // namespace
} // namespace plica

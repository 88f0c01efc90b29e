// Where things touch or sit on plates.
#include "diagnose/effects/chosen_effects.hpp"
#include "diagnose/effects/place_nodes.hpp"
#include "diagnose/effects/plate_places.hpp"
#include "io/tables/effect_words.hpp"
#include "reduction/parametric_model.hpp"
#include "tests/changed_beam.hpp"
#include "tests/moving_motion.hpp"
#include "tests/steel_plate.hpp"
#include "words/input_error.hpp"

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

Case plate_case() {
  Case c = steel_plate({{{0, 0, 0}, {0.3, 0, 0}, {0.3, 0.16, 0}, {0, 0.24, 0}}}, {12, 8});
  c.analyses.modes = Modes{.count = 8};
  c.analyses.damping.modal = 0.01;
  c.caps.push_back({.name = "clamp", .of = {"plate.edge4"}});
  c.mount.push_back({.cap = "clamp"});
  c.sensors.push_back({.name = "corner", .at = {0.3, 0, 0}, .mass = 4e-3});
  return c;
}

// A flat rectangle that moves along its normal by a polynomial that Adini's hold: all of degree
// three, and x^3 y and x y^3.
TEST(PlatePlaces, a_spring_anywhere_on_a_plate_feels_a_cubic_as_it_is) {
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
TEST(PlatePlaces, anywhere_on_a_plate_answers_as_the_mesh_does_at_its_nodes) {
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

// A plate that is warped, aslant: moved without strain a mass on it moves as it does, and all of it
// weighs.
TEST(PlatePlaces, a_mass_anywhere_on_a_warped_plate_moves_with_it_and_weighs) {
  Case c = plate_case();
  std::get<Plate>(c.parts[0].body).corners = {
      {{0, 0, 0}, {0.3, 0, 0.1}, {0.28, 0.2, 0.15}, {0, 0.22, -0.02}}};
  c.sensors.clear();
  const BuiltCase built = build(c);
  const Measured m;
  const Structure s{.data = c, .built = built, .measured = m};
  const PlateGrid grid = plate_grids(s).front();
  std::vector<ModelChange> all;
  VectorXd x(0);
  const Eigen::Vector2d place(0.6 * grid.length[0], 0.45 * grid.length[1]);
  for (int axis = 0; axis < 3; ++axis) {
    const MovingMotion motion = motion_on(s, grid, Vector3d::Unit(axis), MotionTerm::Of::mass);
    for (int moved = 0; moved < 3; ++moved)
      EXPECT_NEAR(motion_of(motion, place, [&](int, int dof) { return dof == moved ? 1. : 0.; }),
                  axis == moved ? 1 : 0, 1e-12);
    all.insert(all.end(), motion.terms.begin(), motion.terms.end());
    const VectorXd own = motion.factors(place);
    x.conservativeResize(x.size() + own.size());
    x.tail(own.size()) = own;
  }
  const ParametricModel model(built.model, built.held_nodes, {}, 10);
  const AffineModel affine = model.with(model.prepare(all));
  constexpr double mass = 0.3;
  EXPECT_NEAR(affine.weight(std::sqrt(mass) * x) - affine.mass, mass, 1e-9);
}

// A part that is too short for what a prior says is left out; where none is long enough it is
// refused.
TEST(PlatePlaces, a_prior_of_a_place_binds_the_parts_that_reach_it) {
  Case c = plate_case();
  BeamPart beam;
  beam.points = {{0.3, 0, 0}, {0.3, -0.6, 0}};
  beam.elements = 4;
  beam.up = {0, 0, 1};
  beam.section.shape = BeamShape::rectangle;
  beam.section.material = "steel";
  beam.section.width = beam.section.depth = 0.01;
  c.parts.push_back({"beam", beam});
  c.caps.push_back({.name = "joint", .of = {"plate.corner2", "beam.start"}});
  c.diagnose.priors = {
      {.effect = "added_mass", .parameter = "at", .between = {0.4, 0.5}, .widening = {}}};
  const Measured m;
  const BuiltCase built = build(c);
  const Structure s{.data = c, .built = built, .measured = m, .stiffness = 1e4, .mass = 1};
  std::set<std::string> places;
  for (const Hypothesis& h : chosen_effects(s).hypotheses)
    if (h.effect == "added_mass" && !h.along.empty()) places.insert(h.place);
  EXPECT_EQ(places, std::set<std::string>{"beam"});
  c.diagnose.priors[0].between = {0.7, 0.8};
  EXPECT_THROW(chosen_effects(s), InputError);
}

TEST(PlatePlaces, a_plate_has_spots_named_by_percents_of_its_edges_where_a_case_asks_for_them) {
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
TEST(PlatePlaces, a_mass_on_a_plate_off_its_sensors_is_told_within_its_intervals) {
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
  constexpr double widths[] = {0.05, 0.06, 0.06}; // kg, m
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LT(e.parameters[i].interval[1] - e.parameters[i].interval[0], widths[i]) << d.headline;
  EXPECT_NE(d.headline.find(" m along and "), std::string::npos) << d.headline;
  EXPECT_NE(plain_at_place(e).find(" m across"), std::string::npos) << plain_at_place(e);
}

} // namespace
} // namespace plica

// What touches or sits on a part that is read from a file, against closed form.
#include "diagnose/effects/chosen_effects.hpp"
#include "diagnose/effects/wall_spots.hpp"
#include "io/input/measured_file.hpp"
#include "io/tables/ledger_words.hpp"
#include "tests/abaqus_plate.hpp"
#include "tests/changed_beam.hpp"
#include "tests/deck_panel.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

using namespace test::deck_panel;
constexpr int along = 24, across = 16;

Case panel() {
  return drawn(along, across);
}

// Navier's modes, up to 18 half waves either way.
struct NavierPlate {
  static constexpr int waves = 18;
  VectorXd lambda{waves * waves}; // (rad/s)^2
  static double mass() { return rho * thickness * length * width; }
  NavierPlate() {
    const double D = E * std::pow(thickness, 3) / (12 * (1 - nu * nu));
    each([&](Index i, int p, int q) {
      const double k2 =
          std::pow(p * std::numbers::pi / length, 2) + std::pow(q * std::numbers::pi / width, 2);
      lambda[i] = D * k2 * k2 / (rho * thickness);
    });
  }
  template <class Act> static void each(const Act& act) {
    for (int p = 1, i = 0; p <= waves; ++p)
      for (int q = 1; q <= waves; ++q) act(Index(i++), p, q);
  }
  // Of mass one, at a point.
  VectorXd motion(double x, double y) const {
    VectorXd w(lambda.size());
    each([&](Index i, int p, int q) {
      w[i] = 2 / std::sqrt(mass()) * std::sin(p * std::numbers::pi * x / length) *
             std::sin(q * std::numbers::pi * y / width);
    });
    return w;
  }
  // The lowest eight, Hz, with a mass and a spring at a point.
  VectorXd frequencies(double x, double y, double m, double k) const {
    const VectorXd w = motion(x, y);
    MatrixXd K = k * w * w.transpose(), M = m * w * w.transpose();
    K.diagonal() += lambda;
    M.diagonal().array() += 1;
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(K, M, Eigen::EigenvaluesOnly);
    return solver.eigenvalues().head(8).cwiseSqrt() / (2 * std::numbers::pi);
  }
};

// Hit and weighed before and after; every mode as mounted anew some ten-thousandths off.
Measured before_and_after(double x, double y, double mass, double spring) {
  constexpr std::array anew{4e-4, -6e-4, 2e-4, 5e-4, -4e-4, 3e-4, -2e-4, 1e-4};
  const NavierPlate plate;
  Measured m;
  m.specimen = "panel";
  m.states = {{.name = "before", .baseline = true, .set = {}, .numbers = {}},
              {.name = "after", .baseline = false, .set = {}, .numbers = {}}};
  const auto add = [&](const std::string& state, const VectorXd& hertz, double weight) {
    for (Index i = 0; i < hertz.size(); ++i) {
      MeasuredMode mode;
      mode.shape = MeasuredShape::other;
      mode.order = int(i) + 1;
      mode.state = state;
      mode.frequency = hertz[i] * (state == "after" ? 1 + anew[std::size_t(i)] : 1);
      m.modes.push_back(mode);
    }
    m.weighings.emplace_back().value = weight;
    m.weighings.back().state = state;
  };
  add("before", plate.frequencies(x, y, 0, 0), NavierPlate::mass());
  add("after", plate.frequencies(x, y, mass, spring), NavierPlate::mass() + mass);
  return m;
}

// Of a corner and its mirror images over both middles the nearest, since frequencies of a rectangle
// do not tell them apart.
double distance_to(const NamedEffect& e, const BuiltCase& built, double x, double y) {
  for (const Spot& spot : wall_spots(built, "panel"))
    if (spot.place == e.place) {
      const Eigen::Vector3d& at = built.model.mesh.nodes[std::size_t(spot.touched)];
      return std::hypot(std::min(std::abs(at.x() - x), std::abs(length - at.x() - x)),
                        std::min(std::abs(at.y() - y), std::abs(width - at.y() - y)));
    }
  return std::numeric_limits<double>::infinity();
}

TEST(WallSpots, are_spread_over_what_may_move_and_lie_between_those_that_are_looked_at) {
  const BuiltCase built = build(panel());
  const std::vector<Spot> spots = wall_spots(built, "panel");
  ASSERT_EQ(spots.size(), std::size_t((along - 1) * (across - 1))) << "all that may move";
  std::set<std::string> looked_at, listed;
  for (const Spot& spot : spots) {
    const Eigen::Vector3d& x = built.model.mesh.nodes[std::size_t(spot.touched)];
    EXPECT_GT(std::min({x.x(), x.y(), length - x.x(), width - x.y()}), 1e-6) << spot.place;
    ASSERT_TRUE(spot.normal.has_value());
    EXPECT_NEAR(std::abs(spot.normal->z()), 1, 1e-12);
    EXPECT_EQ(spot.place.substr(0, 11), "panel.spot[");
    if (spot.between.empty()) looked_at.insert(spot.place);
  }
  EXPECT_EQ(looked_at.size(), 24U);
  double farthest = 0; // of any node from the next spot
  for (const Eigen::Vector3d& x : built.model.mesh.nodes) {
    double nearest = length;
    for (const Spot& spot : spots)
      nearest = std::min(nearest, (built.model.mesh.nodes[std::size_t(spot.touched)] - x).norm());
    farthest = std::max(farthest, nearest);
  }
  EXPECT_LT(farthest, 1.5 * std::sqrt(length * width / double(spots.size())));
  for (const Spot& spot : spots) {
    double shares = spot.between.empty() ? 1 : 0;
    for (const auto& [place, share] : spot.between) {
      EXPECT_TRUE(listed.contains(place)) << "before it";
      shares += share;
    }
    EXPECT_NEAR(shares, 1, 1e-12);
    listed.insert(spot.place);
  }
}

TEST(WallSpots, a_place_whose_neighbours_the_case_leaves_out_is_looked_at_itself) {
  Case c = panel();
  const BuiltCase built = build(c);
  const std::vector<Spot> spots = wall_spots(built, "panel");
  const auto between = std::find_if(spots.begin(), spots.end(),
                                    [](const Spot& spot) { return !spot.between.empty(); });
  ASSERT_NE(between, spots.end());
  c.diagnose.places = {between->place};
  c.diagnose.effects = {"extra_support"};
  const Measured m;
  const std::vector<Hypothesis> own =
      chosen_effects({.data = c, .built = built, .measured = m, .stiffness = 1e4, .mass = 1})
          .hypotheses;
  ASSERT_EQ(own.size(), 1U);
  EXPECT_EQ(own.front().way, "along the normal");
  EXPECT_TRUE(own.front().between.empty());
}

// What a spot of the closest stands for.
const double a_spot = 1.5 * std::sqrt(length * width / 384);

// The scale feels what supports hold as well: the edges of the panel.
TEST(WallSpots, a_part_weighs_what_it_is_whatever_holds_it) {
  const Case c = panel();
  Measured m;
  m.specimen = "panel";
  m.weighings.emplace_back().value = 1;
  const Nominal nominal = nominal_of(c, m);
  const TestReadings readings = readings_of({.data = m, .responses = {}});
  const VectorXd y = *Predictor(nominal, readings, {})(VectorXd());
  ASSERT_EQ(y.size(), 1);
  EXPECT_NEAR(std::exp(y[0]), NavierPlate::mass(), 1e-9);
}

TEST(WallSpots, a_mass_on_a_deck_is_found_where_it_sits) {
  const Case c = panel();
  constexpr double x = 0.211, y = 0.072, mass = 0.05;
  const Diagnosis d = changed_beam::diagnosis_of(c, before_and_after(x, y, mass, 0));
  EXPECT_TRUE(d.verdict == Verdict::identified || d.verdict == Verdict::ambiguous) << d.headline;
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "added_mass") << d.headline;
  ASSERT_TRUE(e.within.has_value()) << d.headline;
  EXPECT_LT(distance_to(e, build(c), x, y), std::min(*e.within, a_spot)) << e.place;
  EXPECT_LE(e.parameters[0].interval[0], mass) << d.headline;
  EXPECT_GE(e.parameters[0].interval[1], mass) << d.headline;
  EXPECT_NE(plain_verdict(d).find(", within 0."), std::string::npos) << plain_verdict(d);
}

// Normals of shells that are listed either way round; of those that stand across each other none.
TEST(WallSpots, a_normal_is_that_of_the_wall_however_its_corners_are_listed) {
  BuiltCase built = build(panel());
  std::vector<ShellQuad>& quads = built.model.mesh.quads;
  for (std::size_t q = 0; q < quads.size(); q += 2)
    std::reverse(quads[q].nodes.begin(), quads[q].nodes.end());
  const std::vector<Spot> spots = wall_spots(built, "panel");
  ASSERT_FALSE(spots.empty());
  for (const Spot& spot : spots) {
    ASSERT_TRUE(spot.normal.has_value()) << spot.place;
    EXPECT_NEAR(std::abs(spot.normal->z()), 1, 1e-12);
  }
}

TEST(WallSpots, something_that_touches_a_deck_is_found_where_it_touches) {
  const Case c = panel();
  constexpr double x = 0.118, y = 0.061, stiffness = 2e5;
  const Diagnosis d = changed_beam::diagnosis_of(c, before_and_after(x, y, 0, stiffness));
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "extra_support") << d.headline;
  ASSERT_TRUE(e.within.has_value()) << d.headline;
  EXPECT_LT(distance_to(e, build(c), x, y), std::min(*e.within, a_spot)) << e.place;
}

// The roller beam as a deck of shells that bends about its weak axis alone: 501 x 51 x 6.66 mm with
// 70 g of an accelerometer, without the roller that touched it (cases/roller_beam).
Case roller_deck() {
  Case c = test::deck_beam({.width = 0.051,
                            .length = 0.501,
                            .thickness = 6.66e-3,
                            .E = 2.02e11,
                            .rho = 7850,
                            .elements = 60,
                            .sensor = 41});
  PointMass accelerometer;
  accelerometer.at = "beam.SENSOR";
  accelerometer.mass = 0.07;
  c.parts.push_back({"accelerometer", accelerometer});
  c.diagnose.model_error = 0.02;
  return c;
}

// Two measured frequencies say that something touches it, and within how far.
void expect_the_roller(int station, double at) {
  const Case c = roller_deck();
  const Measured m = test::by_order_alone(read_measured(
      PLICA_SOURCE_DIR "/cases/roller_beam/station_" + std::to_string(station) + "/measured.yaml"));
  const Diagnosis d = changed_beam::diagnosis_of(c, m);
  EXPECT_EQ(d.verdict, Verdict::ambiguous) << d.headline;
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "extra_support") << d.headline;
  ASSERT_TRUE(e.within.has_value()) << d.headline;
  bool found = false;
  for (const Spot& spot : wall_spots(build(c), "beam"))
    if (spot.place == e.place) {
      const double y = build(c).model.mesh.nodes[std::size_t(spot.touched)].y();
      EXPECT_LT(std::abs(y - at), std::min(*e.within, 0.06)) << station << ": " << d.headline;
      found = true;
    }
  EXPECT_TRUE(found) << e.place;
}

TEST(WallSpots, the_roller_touches_a_measured_beam_that_is_drawn_as_a_deck) {
  expect_the_roller(4, 0.1330);
}

TEST(WallSpotsSlow, the_roller_touches_at_every_station) {
  const std::array stations{0.0639, 0.0867, 0.1103, 0.1330, 0.1564, 0.1798};
  for (std::size_t k = 0; k < stations.size(); ++k) expect_the_roller(int(k) + 1, stations[k]);
}

} // namespace
} // namespace plica

// Bolts tightened in the state of a case, against closed forms.
#include "tests/bellows_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace plica::test {
namespace {

// A slender rod through a sleeve, both between the same two flanges.
struct BoltedSleeve {
  static constexpr double length = 0.2, E = 200e9, rho = 7850;
  double rod_radius = 2e-3, sleeve_radius = 60e-3, sleeve_wall = 3e-3;
  double rod_EA() const { return E * M_PI * rod_radius * rod_radius; }
  double rod_EI() const { return E * M_PI * std::pow(rod_radius, 4) / 4; }
  double rod_mass() const { return rho * M_PI * rod_radius * rod_radius; } // per length
  double sleeve_EA() const { return E * 2 * M_PI * sleeve_radius * sleeve_wall; }

  static Part beam(const std::string& name, int elements, const BeamSection& section) {
    BeamPart beam;
    beam.points = {{0, 0, 0}, {0, length, 0}};
    beam.elements = elements;
    beam.section = section;
    beam.section.material = "steel";
    return {name, beam};
  }

  Case data(double force) const {
    Case c;
    c.name = "bolted_sleeve";
    c.materials["steel"] = {.E = E, .nu = 0.3, .rho = rho};
    BeamSection solid, pipe;
    solid.shape = BeamShape::solid;
    solid.radius = rod_radius;
    pipe.radius = sleeve_radius;
    pipe.thickness = sleeve_wall;
    c.parts = {beam("rod", 24, solid), beam("sleeve", 8, pipe)};
    c.caps = {{.name = "left", .of = {"rod.start", "sleeve.start"}},
              {.name = "right", .of = {"rod.end", "sleeve.end"}}};
    c.mount = {{.cap = "left"}};
    c.analyses.statics = false;
    c.analyses.error_bars = false;
    c.analyses.modes = Modes{.count = 4};
    if (force != 0) {
      c.state.emplace();
      c.state->bolt = {{.part = "rod", .force = force}};
    }
    return c;
  }
};

// Circular frequency of the first mode of a clamped beam that bears a tension T: with
// a^2, b^2 = sqrt(s^2 + m w^2 / EI) +- s, s = T / (2 EI),
//   2 a b (1 - cosh aL cos bL) + (a^2 - b^2) sinh aL sin bL = 0
// (Bokaian, J. Sound Vib. 142 (1990) 481-498), divided by cosh aL.
double clamped_under_tension(double T, double EI, double mass, double length) {
  const auto determinant = [&](double w) {
    const double s = T / (2 * EI), r = std::sqrt(s * s + mass * w * w / EI);
    const double a = std::sqrt(r + s), b = std::sqrt(r - s);
    return 2 * a * b * (1 / std::cosh(a * length) - std::cos(b * length)) +
           (a * a - b * b) * std::tanh(a * length) * std::sin(b * length);
  };
  // Between the frequency of the string and half as much again there is the first one alone.
  const double string =
      M_PI / length * std::sqrt(T / mass + std::pow(M_PI / length, 2) * EI / mass);
  double low = string, high = 1.9 * string;
  EXPECT_LT(determinant(low) * determinant(high), 0);
  for (int i = 0; i < 80; ++i) {
    const double middle = (low + high) / 2;
    (determinant(low) * determinant(middle) <= 0 ? high : low) = middle;
  }
  return low;
}

// How far the right flange moves along the sleeve.
double flange_moves(const Results& results) {
  const Eigen::MatrixXd& moved = results.state->displacement;
  for (std::size_t n = 0; n < results.mesh.nodes.size(); ++n) // places in the state
    if (const double u = moved(Eigen::Index(n), 1);
        results.mesh.nodes[n].y() - u > BoltedSleeve::length * (1 - 1e-9))
      return u;
  throw std::out_of_range("no node at the right flange");
}

TEST(StateBolts, press_what_they_hold_together) {
  const BoltedSleeve s;
  constexpr double F = 1500;
  const Results results = run_silently(s.data(F));
  ASSERT_EQ(results.state->bolts.size(), 1);
  const BoltResult& bolt = results.state->bolts.front();
  EXPECT_EQ(bolt.part, "rod");
  EXPECT_EQ(bolt.force, F);
  // The sleeve becomes shorter, the rod longer.
  EXPECT_NEAR(flange_moves(results), -F * s.length / s.sleeve_EA(),
              1e-3 * F * s.length / s.sleeve_EA());
  EXPECT_NEAR(bolt.shortened / (F * s.length * (1 / s.rod_EA() + 1 / s.sleeve_EA())), 1, 1e-3);
  for (const EndReaction& r : results.state->reactions) // by themselves in balance
    for (double f : r.force) EXPECT_NEAR(f, 0, 1e-6 * F);
}

TEST(StateBolts, bear_their_force_as_a_string_does) {
  const BoltedSleeve s;
  constexpr double F = 1500;
  const Results rest = run_silently(s.data(0)), tight = run_silently(s.data(F));
  const double expected = clamped_under_tension(F, s.rod_EI(), s.rod_mass(), s.length) / (2 * M_PI);
  compare("rod tightened in a sleeve", "first frequency of the rod", tight.modes[0].frequency,
          expected, 0.01);
  EXPECT_GT(tight.modes[0].frequency, 1.1 * rest.modes[0].frequency);
}

// Whatever else acts: the sleeve is pulled by 20 kN, and the rod bears what its bolt says.
TEST(StateBolts, bear_their_force_beside_other_loads) {
  const BoltedSleeve s;
  constexpr double F = 1500, pull = 20e3;
  Case data = s.data(F);
  data.state->force = {{.cap = "right", .force = {0, pull, 0}}};
  const Results results = run_silently(data);
  const double stretch = (pull - F) * s.length / s.sleeve_EA();
  EXPECT_NEAR(flange_moves(results), stretch, 1e-3 * stretch);
  EXPECT_NEAR(results.state->bolts.front().shortened, F * s.length / s.rod_EA() - stretch,
              1e-3 * stretch);
}

// Tightened, it is as stiff as before: the axial stiffness is that of both.
TEST(StateBolts, are_elastic_once_tightened) {
  const BoltedSleeve s;
  Case data = s.data(1500);
  data.mount.push_back({.cap = "right"});
  data.analyses.modes.reset();
  data.analyses.statics = true;
  const double both = (s.rod_EA() + s.sleeve_EA()) / s.length;
  EXPECT_NEAR(run_silently(data).statics->k_axial / both, 1, 1e-3);
}

} // namespace
} // namespace plica::test

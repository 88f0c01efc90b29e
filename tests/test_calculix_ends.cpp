// Chosen ends that move with amplitude and phase, beside CalculiX on the same mesh.
//
// CalculiX 2.20 breaks off on imaginary boundary values, so the ends carry 1e5 kg each there
// (40,000 times the pipe) and a force pushes each with the acceleration it is to have; fractions of
// critical act on what moves against them, as here. The ground behind springs moves in the deck
// that Plica writes by the force of the springs, which CalculiX takes as it stands.
#include "tests/pipe_case.hpp"
#include "tests/run_calculix.hpp"

#include "io/decks/write_abaqus.hpp"

#include <cmath>
#include <complex>
#include <fmt/format.h>
#include <numbers>
#include <sstream>

namespace plica::test {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr double seismic = 1e5; // kg

// A pipe of 0.3 m between two rigid ends, watched in its middle.
Case pipe_between_ends() {
  Case data = pipe_of({2e-3});
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.sensors = {{.name = "mid", .at = {0.03, 0.15, 0}}};
  data.analyses.modes = Modes{.count = 16};
  data.analyses.damping.modal = 0.02;
  return data;
}

// Motion along x of the left end, and of the right one of the given amplitude 60 degrees ahead.
Response both_ends(double right) {
  Motion motion;
  motion.name = "both";
  motion.move = {"left"};
  motion.direction = 0;
  EndMotion other;
  other.move = {"right"};
  other.direction = 0;
  other.amplitude = right;
  other.phase = pi / 3;
  motion.with = {other};
  return {.bases = {}, .motions = {motion}, .band = {100, 1000}, .points = 5};
}

using Motions = std::vector<std::pair<double, std::array<Complex, 3>>>; // Hz, ux uy uz

// What CalculiX prints of the sensor; empty where it is not installed or breaks off.
Motions calculix_motions(const std::string& deck) {
  std::istringstream stream(calculix_output(deck));
  Motions motions;
  bool imaginary = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.find("displacements (vx,vy,vz) for set MID") == std::string::npos) continue;
    const double hertz = std::stod(line.substr(line.rfind("time") + 4));
    std::getline(stream, line);
    std::getline(stream, line);
    std::istringstream fields(line);
    int node = 0;
    std::array<double, 3> u{};
    fields >> node >> u[0] >> u[1] >> u[2];
    if (!imaginary) motions.push_back({hertz, {}});
    for (std::size_t k = 0; k < 3; ++k)
      motions.back().second[k] += imaginary ? Complex(0, u[k]) : Complex(u[k], 0);
    imaginary = !imaginary;
  }
  return motions;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  if (at == std::string::npos) throw std::runtime_error("the deck has no " + what);
  return text.replace(at, what.size(), by);
}

// Everything before the steps, and the modes of the step that every response needs.
std::string deck_with_modes(const Case& data) {
  const std::string deck = abaqus_model(data, build(data));
  return deck.substr(0, deck.find("*STEP")) +
         "*STEP\n*FREQUENCY, STORAGE=YES\n16\n*NODE FILE\nU\n*END STEP\n";
}

// Number in the deck of the node of each mass.
std::vector<std::string> nodes_of_masses(const std::string& deck) {
  std::vector<std::string> nodes;
  for (auto at = deck.find("TYPE=MASS"); at != std::string::npos;
       at = deck.find("TYPE=MASS", at + 1)) {
    std::istringstream line(deck.substr(deck.find('\n', at) + 1));
    std::string element, node;
    std::getline(line, element, ',');
    std::getline(line, node);
    nodes.push_back(node);
  }
  return nodes;
}

void expect_alike(const Results& results, const Motions& motions, bool accelerations) {
  const ResponseResult& r = results.responses.at(0);
  int compared = 0;
  for (const auto& [hertz, u] : motions) {
    Eigen::Index at = 0;
    if ((r.hertz.array() - hertz).abs().minCoeff(&at) > 1e-3 * hertz) continue;
    ++compared;
    const double w2 = std::pow(2 * pi * hertz, 2);
    double difference = 0, size = 0;
    for (int k = 0; k < 3; ++k) {
      const Complex own = r.acceleration(at, k);
      const Complex other = accelerations ? -w2 * u[std::size_t(k)] : u[std::size_t(k)];
      difference += std::norm(own - other);
      size += std::norm(own);
    }
    EXPECT_LT(std::sqrt(difference / size), 0.01) << hertz << " Hz";
  }
  EXPECT_GE(compared, 4);
}

TEST(CalculixEnds, two_held_ends_that_move_with_a_phase) {
  Case data = pipe_between_ends();
  data.analyses.response = both_ends(0.5);
  Case heavy = data;
  heavy.analyses.response.reset();
  for (Cap& cap : heavy.caps) cap.mass = seismic;
  for (Mount& mount : heavy.mount) {
    mount.kind = MountKind::springs;
    mount.stiffness = {1, 1e13, 1e13, 1e10, 1e10, 1e10};
  }
  std::string deck = deck_with_modes(heavy);
  const std::vector<std::string> ends = nodes_of_masses(deck);
  ASSERT_EQ(ends.size(), 2u);
  deck +=
      fmt::format("*STEP\n*STEADY STATE DYNAMICS\n100., 1000., 6, 1.\n*MODAL DAMPING\n1, 16, "
                  "2.e-2\n*CLOAD, LOAD CASE=1\n{}, 1, {}\n{}, 1, {}\n*CLOAD, LOAD CASE=2\n{}, 1, "
                  "{}\n*NODE PRINT, NSET=MID\nU\n*END STEP\n",
                  ends[0], seismic, ends[1], seismic * 0.5 * std::cos(pi / 3), ends[1],
                  seismic * 0.5 * std::sin(pi / 3));
  const Motions motions = calculix_motions(deck);
  ASSERT_FALSE(motions.empty()) << "CalculiX (ccx) is not installed, or broke off";
  data.analyses.response->points = 6; // 100, 280, .. Hz, as there
  expect_alike(run_silently(data), motions, true);
}

// One end on springs whose ground moves: the deck as Plica writes it, but for its frequencies.
TEST(CalculixEnds, the_ground_behind_springs_in_the_deck_that_is_written) {
  Case data = pipe_between_ends();
  data.caps[1].mass = 1.5;
  data.mount[1].kind = MountKind::springs;
  data.mount[1].stiffness = {1e6, 2e6, 5e5, 0, 3e3, 0};
  data.analyses.damping.modal = 1e-4; // acts on all that moves there, here on what moves against R
  Response response = both_ends(0.5);
  response.motions[0].move = {"right"};
  response.motions[0].phase = pi / 3;
  response.motions[0].with.clear();
  response.band = {50, 400};
  data.analyses.response = response;
  std::string deck =
      replaced(abaqus_model(data, build(data)), "*FREQUENCY\n", "*FREQUENCY, STORAGE=YES\n");
  deck = replaced(deck, "5.000000000e+01, 4.000000000e+02, 20, 3.", "50., 400., 6, 1.");
  const Motions motions = calculix_motions(deck);
  ASSERT_FALSE(motions.empty()) << "CalculiX (ccx) is not installed, or broke off";
  data.analyses.response->points = 3501; // CalculiX has its own steps between its frequencies
  const Results results = run_silently(data);
  Motions away; // of the resonances, whose frequencies differ by 0.1 %
  for (const auto& m : motions)
    if (std::none_of(results.modes.begin(), results.modes.end(), [&](const ModeResult& mode) {
          return std::abs(mode.frequency / m.first - 1) < 0.1;
        }))
      away.push_back(m);
  expect_alike(results, away, false);
}

} // namespace
} // namespace plica::test

// A line whose parts are superelements, beside the same line unreduced in CalculiX.
#include "tests/bellows_case.hpp"
#include "tests/calculix_frequencies.hpp"

#include <cmath>

namespace plica::test {
namespace {

Bellows stretch_of(double start, const std::vector<MeridianSection>& profile, double wall,
                   const MeshDensity& mesh) {
  Bellows b;
  b.material = "steel";
  b.root_radius = 0.04;
  b.start = start;
  b.profile = profile;
  b.wall.plies = {wall};
  b.mesh = mesh;
  return b;
}

MeridianSection straight_stretch(double length, int elements) {
  MeridianSection s;
  s.shape = SectionShape::cuff;
  s.length = length;
  s.elements = elements;
  return s;
}

// Held, a pipe, a decoupler, a pipe with a body beside its end on springs, all of shells.
Case line_of_shells(const Bellows& decoupler, double length, const MeshDensity& pipes) {
  Case data;
  data.name = "line";
  data.materials["steel"] = {.E = 193e9, .nu = 0.3, .rho = 8000};
  const double start = 0.2;
  Bellows soft = decoupler;
  soft.start = start;
  data.parts = {{"front", stretch_of(0, {straight_stretch(start, 20)}, 2e-3, pipes)},
                {"decoupler", soft},
                {"rear", stretch_of(start + length, {straight_stretch(0.3, 30)}, 2e-3, pipes)}};
  data.caps = {{.name = "engine", .of = {"front.left"}},
               {.name = "first", .of = {"front.right", "decoupler.left"}, .mass = 0.3},
               {.name = "second", .of = {"decoupler.right", "rear.left"}, .mass = 0.3},
               {.name = "muffler", .of = {"rear.right"}, .mass = 2}};
  data.caps[3].inertia = {4e-3, 2e-3, 5e-3, 3e-4, 0, 0};
  data.caps[3].offset = {0.02, 0.04, -0.01};
  data.mount = {{.cap = "engine"}, {.cap = "muffler"}};
  data.mount[1].kind = MountKind::springs;
  data.mount[1].stiffness = {2e4, 1e4, 5e4, 0, 0, 0};
  data.analyses.statics = false;
  data.analyses.error_bars = false;
  data.analyses.modes = Modes{.count = 8};
  return data;
}

// The lowest eight modes; superelements within half a percent of the line unreduced.
void expect_beside_calculix(const Case& data, double cutoff, double tolerance) {
  const Results whole = run_silently(data);
  Case reduced_case = data;
  reduced_case.analyses.reduction = SuperelementsInRun{.cutoff = cutoff};
  const Results reduced = run_silently(reduced_case);
  EXPECT_NE(reduced.route.find("3 superelements"), std::string::npos) << reduced.route;
  ASSERT_TRUE(reduced.verification.passed);
  const std::vector<double> theirs = calculix_frequencies(data);
  ASSERT_EQ(theirs.size(), whole.modes.size()) << "CalculiX (ccx) is not installed, or broke off";
  for (std::size_t i = 0; i < theirs.size(); ++i) {
    const double own = reduced.modes[i].frequency, unreduced = whole.modes[i].frequency;
    std::printf("  mode %zu: %.3f Hz of superelements, %.3f Hz unreduced, %.3f Hz unreduced in "
                "CalculiX\n",
                i + 1, own, unreduced, theirs[i]);
    print_for_table("line of superelements, mode " + std::to_string(i + 1) +
                        ", unreduced in CalculiX",
                    own, theirs[i], tolerance);
    EXPECT_NEAR(own / unreduced, 1, 5e-3) << i;
    EXPECT_NEAR(own / theirs[i], 1, tolerance) << i;
  }
}

TEST(LineInCalculix, of_pipes_and_a_sleeve) {
  const MeshDensity pipes{.around = 24, .arc = 1, .wall = 10};
  expect_beside_calculix(
      line_of_shells(stretch_of(0, {straight_stretch(0.08, 8)}, 0.3e-3, pipes), 0.08, pipes), 6000,
      0.01);
}

// Four convolutions of one wall, meshed so finely that the shells of CalculiX are not too stiff.
TEST(LineInCalculixSlow, of_pipes_and_a_decoupler) {
  const MeshDensity pipes{.around = 24, .arc = 1, .wall = 10},
      folds{.around = 32, .arc = 8, .wall = 8};
  MeridianSection folded;
  folded.shape = SectionShape::u;
  folded.count = 4;
  folded.height = 0.008;
  folded.pitch = 0.0066;
  expect_beside_calculix(
      line_of_shells(stretch_of(0, {straight_stretch(0.005, 4), folded, straight_stretch(0.005, 4)},
                                0.5e-3, folds),
                     0.01 + 4 * 0.0066, pipes),
      6000, 0.01);
}

} // namespace
} // namespace plica::test

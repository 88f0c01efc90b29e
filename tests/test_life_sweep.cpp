// EJMA formulas beside shells over many bellows, and the shells beside an independent finite
// element model of the same convolutions. Prints the tables of docs/life.md.
//
// Source of the second: shell of revolution by rings, half a convolution between planes of
// symmetry, Dm/w = 40, nu = 0.3, as coefficients Cf and Cd of the EJMA formulas.
#include "model/description/ejma.hpp"
#include "run/study/bellows_shells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace plica::test {
namespace {

constexpr double Dm = 0.1; // m

struct SweepPoint {
  double C1 = 0, C2 = 0, slenderness = 0; // Dm / w
};

// Ply not thinned, so that tp = t; Db follows from Dm = Db + w + t.
EjmaBellows sweep_bellows(const SweepPoint& p, int convolutions) {
  const double w = Dm / p.slenderness, q = 2 * w * p.C1;
  const double rm = q / 4, t = std::pow(1.82 * rm / p.C2, 2) / Dm;
  return {.inner_diameter = Dm - w - t,
          .depth = w,
          .pitch = q,
          .thickness = t,
          .convolutions = convolutions,
          .E = 200e9,
          .nu = 0.3,
          .thinned = false};
}

Case sweep_case(const EjmaBellows& b, double accuracy) {
  MeridianSection section;
  section.count = b.convolutions;
  section.height = b.depth;
  section.pitch = b.pitch;
  Bellows shells;
  shells.material = "steel";
  shells.root_radius = (b.inner_diameter + b.thickness) / 2;
  shells.profile = {section};
  shells.wall.plies = {b.thickness};
  shells.mesh.accuracy = accuracy;
  Case data;
  data.name = "sweep";
  data.materials["steel"] = {.E = b.E, .nu = b.nu, .rho = 7850};
  data.parts.push_back({"bellows", shells});
  data.analyses.symmetry = Symmetry::required;
  return bellows_alone(data, data.parts.front());
}

BellowsStatics sweep_shells(const EjmaBellows& b, double accuracy) {
  return BellowsStatics(sweep_case(b, accuracy), [](const std::string&) {});
}

// Convolutions between convolutions: without the first three and the last three.
std::array<double, 2> inner_part(const EjmaBellows& b) {
  return {2.75 * b.pitch, (b.convolutions - 2.75) * b.pitch};
}

// Shells over formulas; `inner`: axial movement, inner convolutions.
struct SweepRatios {
  double stiffness = 0, inner = 0, axial = 0, lateral = 0, angular = 0;
};

SweepRatios sweep_ratios(const SweepPoint& p) {
  const EjmaBellows b = sweep_bellows(p, 8);
  const EjmaFactors c = ejma_factors(b);
  const BellowsStatics shells = sweep_shells(b, 0.005);
  const auto stress = [&](const EjmaMovement& m, const std::array<double, 2>& between) {
    const EjmaStress s = ejma_stress(b, c, 0, ejma_equivalent(b, m).sum());
    return shells.stress({m.axial, m.lateral, m.angular}, between).face / (s.S5 + s.S6);
  };
  const std::array<double, 2> whole{0, 8 * b.pitch};
  // Small, so that the length that ey is divided by is that of the bellows.
  return {shells.stiffness().k_axial * b.convolutions / ejma_convolution_stiffness(b, c),
          stress({.axial = 1e-9}, inner_part(b)), stress({.axial = 1e-9}, whole),
          stress({.lateral = 1e-6}, whole), stress({.angular = 1e-6}, whole)};
}

struct RingModel {
  double C1, C2, Cf, Cd;
};
constexpr RingModel ring_models[] = {
    {0.2, 0.4, 1.294, 1.344}, {0.4, 0.4, 1.577, 1.637}, {0.6, 0.4, 1.838, 1.907},
    {0.2, 0.8, 1.167, 1.416}, {0.4, 0.8, 1.335, 1.840}, {0.6, 0.8, 1.493, 2.158},
    {0.2, 1.2, 0.950, 1.183}, {0.4, 1.2, 0.929, 1.437}, {0.6, 1.2, 0.922, 1.773},
    {0.2, 2.0, 0.762, 0.956}, {0.4, 2.0, 0.580, 0.933}, {0.6, 2.0, 0.437, 0.937},
    {0.2, 3.0, 0.695, 0.875}, {0.4, 3.0, 0.468, 0.767}, {0.6, 3.0, 0.298, 0.674}};

// What holds whatever the formulas are worth: the inner convolutions are a part of the whole. Ends
// that turn move a fibre by its distance from the axis, which is Dm / 2 but for w / 2. Ends that
// shift bend a beam as they turn it at its ends, and the middle of the first of eight convolutions
// stands at 7/8 of that; soft convolutions leave little to its shear.
void expect_movements_alike(const SweepPoint& p, const SweepRatios& r) {
  EXPECT_GE(r.axial, r.inner);
  EXPECT_NEAR(r.angular / r.axial, 1, 1 / p.slenderness);
  if (p.C2 < 1) return;
  EXPECT_GT(r.lateral / r.angular, 7. / 8);
  EXPECT_LT(r.lateral / r.angular, 1.01); // found 1.001: held ends
}

// The formulas with the coefficients of rings. Stiffness: two held ends of eight convolutions
// (found -3 to +4 %). Stress: the root bears the force on a smaller circle, by 1 / (1 - w / Dm),
// and the concave face of a curved bar bears by t / (2 rm) more (Winkler: 1.30 at rm = 1.5 t).
// Whether there are rings to this bellows.
bool expect_rings(const SweepPoint& p, const SweepRatios& r) {
  const auto* const ring =
      std::find_if(std::begin(ring_models), std::end(ring_models),
                   [&](const RingModel& m) { return m.C1 == p.C1 && m.C2 == p.C2; });
  if (ring == std::end(ring_models)) return false;
  const EjmaBellows b = sweep_bellows(p, 8);
  const EjmaFactors tabulated = ejma_factors(b);
  EjmaFactors of_rings = tabulated;
  of_rings.Cf = ring->Cf;
  of_rings.Cd = ring->Cd;
  EXPECT_NEAR(r.stiffness * ring->Cf / tabulated.Cf, 1, 0.05);
  const EjmaStress s = ejma_stress(b, tabulated, 0, 1), rings = ejma_stress(b, of_rings, 0, 1);
  const double inner = r.inner * (s.S5 + s.S6) / (rings.S5 + rings.S6);
  EXPECT_GT(inner, 1);
  EXPECT_LT(inner, (1 + 2 * b.thickness / b.pitch) / (1 - 1 / p.slenderness)); // rm = q / 4
  return true;
}

TEST(EjmaSweepSlow, shells_beside_the_formulas_over_ninety_bellows) {
  std::printf("| Dm/w | C1 | C2 | stiffness | axial, inner | axial | lateral | angular |\n"
              "|---|---|---|---|---|---|---|---|\n");
  int count = 0, of_rings = 0;
  for (const double slenderness : {8., 20.})
    for (const double C1 : {0.2, 0.3, 0.4, 0.5, 0.6})
      for (const double C2 : {0.4, 0.6, 0.8, 1.0, 1.2, 1.6, 2.0, 2.5, 3.0}) {
        SCOPED_TRACE(testing::Message()
                     << "Dm/w " << slenderness << ", C1 " << C1 << ", C2 " << C2);
        const SweepPoint p{C1, C2, slenderness};
        const SweepRatios r = sweep_ratios(p);
        std::printf("| %g | %g | %g | %.3f | %.3f | %.3f | %.3f | %.3f |\n", slenderness, C1, C2,
                    r.stiffness, r.inner, r.axial, r.lateral, r.angular);
        expect_movements_alike(p, r);
        of_rings += expect_rings(p, r);
        ++count;
      }
  std::printf("%d bellows\n", count);
  EXPECT_EQ(count, 90);
  EXPECT_EQ(of_rings, 30);
}

// Of convolutions between convolutions: what 16 have more than 8.
TEST(EjmaSweepSlow, shells_give_the_coefficients_of_an_independent_ring_model) {
  for (const RingModel& r : ring_models) {
    const EjmaBellows short_one = sweep_bellows({r.C1, r.C2, 40}, 8);
    const EjmaBellows long_one = sweep_bellows({r.C1, r.C2, 40}, 16);
    const BellowsStatics a = sweep_shells(short_one, 0.005), b = sweep_shells(long_one, 0.005);
    const double compliance = (1 / b.stiffness().k_axial - 1 / a.stiffness().k_axial) / 8;
    const double f = 1 / compliance, t = long_one.thickness, w = long_one.depth;
    const double Cf = 1.7 * Dm * long_one.E * std::pow(t / w, 3) / f;
    // Bending by the movement of one inner convolution, under the force of the whole.
    const double movement = 1 / b.stiffness().k_axial; // of 1 N
    const double S6 = b.stress({.axial = movement}, inner_part(long_one)).bending;
    const double Cd = 5 * long_one.E * t * compliance / (3 * w * w * S6);
    std::printf("C1 %g C2 %g: Cf %.3f, ring %.3f (%+.1f %%); Cd %.3f, ring %.3f (%+.1f %%)\n", r.C1,
                r.C2, Cf, r.Cf, 100 * (Cf / r.Cf - 1), Cd, r.Cd, 100 * (Cd / r.Cd - 1));
    EXPECT_NEAR(Cf / r.Cf, 1, 0.01);
    EXPECT_NEAR(Cd / r.Cd, 1, 0.02);
  }
}

} // namespace
} // namespace plica::test

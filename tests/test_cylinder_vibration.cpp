// Free vibration of cylinders and an annular plate, one circumferential harmonic at a time.
//
// A sector of a quarter wave, antisymmetric at its start and symmetric at its end, carries the
// harmonics n, 3n, 5n ...; the modes of n are told by projection on sin(n angle).
// Cylinder: R = 0.1, L = 0.2, t = 0.002 (mid-surface), E = 210e9, nu = 0.3, rho = 7850.
#include "mesh/generation/revolve.hpp"
#include "tests/support/fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace plica;
using namespace plica::test;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

enum class End { clamped, diaphragm, free };

// A surface of revolution about y over a sector; a turns, b runs along the meridian.
struct Sector {
  std::function<SurfacePoint(double angle, double b)> surface;
  ShellSection section;
  double thickness = 0;
  std::array<End, 2> ends{};
  int around = 16, along = 24; // elements of the quarter wave, of the meridian
};

double sector_angle(int n) {
  return n == 0 ? pi / 8 : pi / (2 * n);
}

void support_sector(Model& model, const Sector& sector, int n) {
  const double angle = sector_angle(n);
  std::vector<End> end_of(model.mesh.nodes.size(), End::free);
  for (int e = 0; e < 2; ++e)
    for (int node : model.mesh.sets.at(e == 0 ? "b0" : "b1")) {
      end_of[node] = sector.ends[e];
      if (sector.ends[e] == End::clamped) add_support(model, {node}, all_dofs, "clamp");
      if (sector.ends[e] == End::diaphragm) add_support(model, {node}, {0, 2, 4}, "diaphragm");
    }
  // n = 0: symmetric on both sides.
  const auto symmetry = [&](int node, double at) {
    if (end_of[node] == End::clamped) return;
    const Vector3d tangent(std::cos(at), 0, -std::sin(at)), radius(std::sin(at), 0, std::cos(at));
    if (end_of[node] == End::free) {
      hold_along(model, node, 0, tangent);
      hold_along(model, node, 3, Vector3d::UnitY());
    }
    hold_along(model, node, 3, radius);
  };
  for (int node : model.mesh.sets.at("a1")) symmetry(node, angle);
  for (int node : model.mesh.sets.at("a0")) {
    if (n == 0) symmetry(node, 0);
    if (n == 0 || end_of[node] == End::clamped) continue;
    add_support(model, {node}, {1, 2, 3}, "antisymmetry");
  }
}

// The lowest frequencies of harmonic n, Hz.
std::vector<double> harmonic(const Sector& sector, int n, int wanted) {
  const double angle = sector_angle(n);
  const ParametricSurface surface = [&](double a, double b) {
    return sector.surface(a * angle, b);
  };
  Model model = shell_model(mesh_surface(surface, sector.around, sector.along, sector.thickness),
                            sector.section);
  support_sector(model, sector, n);
  const SolvedModes modes = find_modes(model, n == 1 ? 26 : 8);
  std::vector<double> found;
  for (Eigen::Index mode = 0; mode < modes.hertz.size(); ++mode) {
    double of_n = 0, normal_motion = 0, motion = 0; // squares, summed over the nodes
    for (int j = 0; j <= sector.along; ++j) {
      double projection = 0;
      for (int i = 0; i <= sector.around; ++i) {
        const int node = i * (sector.along + 1) + j;
        const double a = double(i) / sector.around, weight = i % sector.around == 0 ? 0.5 : 1;
        const Vector3d normal = surface(a, double(j) / sector.along).normal;
        const Vector3d u = modes.u.col(mode).segment<3>(6 * node);
        const double w = normal.dot(u);
        projection += weight * w * (n == 0 ? std::sqrt(0.5) : std::sin(n * a * angle));
        normal_motion += weight * w * w;
        motion += weight * u.squaredNorm();
      }
      of_n += 2 * projection * projection / sector.around;
    }
    if (of_n > 0.9 * normal_motion && normal_motion > 0.01 * motion)
      found.push_back(modes.hertz[mode]);
  }
  EXPECT_GE(found.size(), static_cast<std::size_t>(wanted)) << "harmonic " << n;
  found.resize(wanted);
  return found;
}

Sector cylinder(End left, End right) {
  return {.surface =
              [](double angle, double b) {
                const Vector3d normal(std::sin(angle), 0, std::cos(angle));
                return SurfacePoint{0.1 * normal + 0.2 * b * Vector3d::UnitY(), normal};
              },
          .section = {.E = 210e9, .nu = 0.3, .rho = 7850},
          .thickness = 0.002,
          .ends = {left, right}};
}

void expect_harmonics(const Sector& sector, int first,
                      const std::vector<std::vector<double>>& wanted, double tolerance) {
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const int n = first + static_cast<int>(k);
    const auto found = harmonic(sector, n, static_cast<int>(wanted[k].size()));
    for (std::size_t m = 0; m < found.size(); ++m)
      expect_ratio(found[m], wanted[k][m], tolerance,
                   "n = " + std::to_string(n) + ", m = " + std::to_string(m + 1));
  }
}

// Fluegge's exact solution, m = 1 and 2. 1 %.
TEST(CylinderVibration, shear_diaphragms) {
  expect_harmonics(cylinder(End::diaphragm, End::diaphragm), 1,
                   {{4943.8, 7308.6},
                    {2833.4, 5661.9},
                    {1741.5, 4237.9},
                    {1354.0, 3281.3},
                    {1477.5, 2815.9},
                    {1909.6, 2806.2}},
                   0.01);
}

// Independent axisymmetric-harmonic shell element, as the next two. 1 %.
TEST(CylinderVibration, clamped_clamped) {
  expect_harmonics(cylinder(End::clamped, End::clamped), 1,
                   {{5051.8, 7339.5},
                    {3284.6, 5728.3},
                    {2324.3, 4406.9},
                    {1859.6, 3564.0},
                    {1803.9, 3146.1},
                    {2089.3, 3107.1}},
                   0.01);
}

TEST(CylinderVibration, clamped_free) {
  expect_harmonics(cylinder(End::clamped, End::free), 1,
                   {{2381.2}, {1202.4}, {771.7}, {851.6}, {1224.2}, {1746.7}}, 0.01);
}

TEST(CylinderVibration, free_free_rayleigh_and_love_modes) {
  expect_harmonics(
      cylinder(End::free, End::free), 2,
      {{132.98, 177.34}, {375.98, 446.97}, {720.43, 803.02}, {1164.0, 1252.0}, {1705.8, 1796.3}},
      0.01);
}

// Annular plate, inside clamped at half the outer radius: omega a^2 sqrt(rho h / D) after Leissa,
// NASA SP-160 (1969), more digits from the independent harmonic shell. 1 %.
TEST(CylinderVibration, annular_plate) {
  constexpr double t = 0.005, E = 2e11, nu = 0.3, rho = 8000;
  const Sector annulus{.surface =
                           [](double angle, double b) {
                             const Vector3d radius(std::sin(angle), 0, std::cos(angle));
                             return SurfacePoint{(0.5 + 0.5 * b) * radius, -Vector3d::UnitY()};
                           },
                       .section = {.E = E, .nu = nu, .rho = rho},
                       .thickness = t,
                       .ends = {End::clamped, End::free}};
  const double unit = std::sqrt(E * t * t / (12 * (1 - nu * nu) * rho)) / (2 * pi);
  std::vector<std::vector<double>> wanted{
      {13.02, 85.0}, {13.29, 86.7}, {14.70, 91.7}, {18.56, 100.1}, {25.59, 112.0}};
  for (auto& pair : wanted)
    for (double& f : pair) f *= unit;
  expect_harmonics(annulus, 0, wanted, 0.01);
}

// The whole free tube: six rigid modes, every elastic one a pair.
Model free_tube() {
  Meridian meridian(0, 0.1);
  meridian.add_cuff(0.2, 0.1, 10);
  return shell_model(revolve(meridian, 40, [](double) { return 0.002; }),
                     {.E = 210e9, .nu = 0.3, .rho = 7850});
}

TEST(FreeTube, has_six_rigid_modes_and_pairs) {
  const Model tube = free_tube();
  for (int count : {9, 10, 14}) {
    const SolvedModes modes = find_modes(tube, count);
    const VectorXd& f = modes.hertz;
    ASSERT_GE(f.size(), count);
    EXPECT_EQ(f.size() % 2, 0) << "a pair is never cut";
    EXPECT_LT(f[5], 1e-3 * f[6]);
    for (Eigen::Index i = 6; i + 1 < f.size(); i += 2) EXPECT_LT(f[i + 1] / f[i] - 1, 1e-6);
    EXPECT_EQ(modes.set.proof.inertia_count, modes.set.proof.found);
    expect_ratio(f[6], 132.98, 0.02, "Rayleigh mode");
    expect_ratio(f[8], 177.34, 0.02, "Love mode");
  }
}

TEST(FreeTube, has_the_same_modes_from_every_start_vector) {
  const System system = assemble(free_tube());
  const double first = std::pow(2 * pi * 132.98, 2);
  SparseFactor factor(system.K);
  const double shift = -0.1 * first;
  VectorXd reference;
  for (unsigned seed : {1, 2, 3, 4, 5}) {
    ASSERT_TRUE(factor.factorise(shifted(system.K, system.M, shift)).ok);
    const int count = 15 + static_cast<int>(seed % 2);
    const EigenPairs pairs =
        lanczos(system.M, factor, shift, {.count = count, .subspace = 0, .seed = seed});
    ASSERT_TRUE(pairs.converged) << pairs.reason;
    if (reference.size() == 0) reference = pairs.values.head(14);
    EXPECT_LE((pairs.values.head(14) - reference).cwiseAbs().maxCoeff(), 1e-9 * reference[13]);
    const InertiaCount count_14 = count_below(
        system.K, system.M, (pairs.values[13] + pairs.values[14]) / 2, pairs.vectors, factor);
    EXPECT_EQ(count_14.below, 14) << count_14.reason;
  }
  const InertiaCount referee = count_below_ldlt(system.K, system.M, 1.01 * reference[13]);
  EXPECT_EQ(referee.below, 14) << referee.reason;
}

} // namespace

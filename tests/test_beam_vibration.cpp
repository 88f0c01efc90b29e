// Free vibration of beam models: NAFEMS frames and closed forms. Frequencies in Hz.
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

const BeamMaterial steel{.E = 200e9, .nu = 0.3, .rho = 8000};

// Nodes of a straight row of beams from a node on; returns them with the first.
std::vector<int> add_row(Model& model, int start, const Vector3d& end, int elements,
                         const BeamProperties& section) {
  std::vector<int> nodes{start};
  const Vector3d from = model.mesh.nodes[start];
  for (int i = 1; i <= elements; ++i) {
    nodes.push_back(add_node(model, from + (end - from) * i / elements));
    model.beams.push_back({.node1 = nodes[i - 1], .node2 = nodes[i], .section = section});
  }
  return nodes;
}

void expect_frequencies(const VectorXd& hertz, const std::vector<double>& wanted,
                        double tolerance) {
  ASSERT_GE(hertz.size(), static_cast<Eigen::Index>(wanted.size()));
  for (std::size_t i = 0; i < wanted.size(); ++i)
    expect_ratio(hertz[static_cast<Eigen::Index>(i)], wanted[i], tolerance,
                 "mode " + std::to_string(i + 1));
}

// Eight arms of 5, four beams each, pinned tips, in plane. 1 %.
TEST(NafemsBeams, fv2_pin_ended_double_cross) {
  Model model;
  const int hub = add_node(model, Vector3d::Zero());
  for (int k = 0; k < 8; ++k) {
    const Vector3d tip(5 * std::cos(k * pi / 4), 5 * std::sin(k * pi / 4), 0);
    const auto arm = add_row(model, hub, tip, 4, rectangle_section(steel, 0.125, 0.125));
    add_support(model, {arm.back()}, {0, 1}, "pin");
  }
  for (int node = 0; node < static_cast<int>(model.mesh.nodes.size()); ++node)
    add_support(model, {node}, {2, 3, 4}, "plane");
  const double f1 = 17.709, f2 = 57.390;
  expect_frequencies(find_modes(model, 16).hertz,
                     {11.336, f1, f1, f1, f1, f1, f1, f1, 45.345, f2, f2, f2, f2, f2, f2, f2},
                     0.01);
}

// Five beams of diameter 0.5; 10000 and 1000 kg on rigid arms of +-2 across the tip. 1 %.
TEST(NafemsBeams, fv4_cantilever_with_off_centre_masses) {
  Model model;
  const int root = add_node(model, Vector3d::Zero());
  add_support(model, {root}, all_dofs, "root");
  const int tip = add_row(model, root, {10, 0, 0}, 5, round_section(steel, 0.25)).back();
  model.masses.push_back({tip, {.mass = 10000, .offset = {0, 2, 0}}});
  model.masses.push_back({tip, {.mass = 1000, .offset = {0, -2, 0}}});
  expect_frequencies(find_modes(model, 6).hertz, {1.723, 1.727, 7.413, 9.972, 18.155, 26.957},
                     0.01);
}

VectorXd deep_beam(int elements) {
  Model model;
  const int a = add_node(model, Vector3d::Zero());
  const int b = add_row(model, a, {10, 0, 0}, elements, rectangle_section(steel, 2, 2)).back();
  add_support(model, {a}, {0, 1, 2, 3}, "A");
  add_support(model, {b}, {1, 2}, "B");
  return find_modes(model, 9).hertz;
}

// 2 x 2 x 10. Torsion with Saint-Venant's J = 0.1406 a4: 71.20 and 213.61 (77.542 and 233.10 would
// be the polar moment). 1 %, third flexure 2 %.
TEST(NafemsBeams, fv5_deep_simply_supported_beam) {
  const VectorXd f = deep_beam(20);
  expect_frequencies(f, {42.649, 42.649, 71.20, 125.00, 148.31, 148.31, 213.61}, 0.01);
  expect_frequencies(f.tail(2), {284.55, 284.55}, 0.02);
}

// rho I rho/(kG) w4 - [rho A + rho I b2 (1 + E/(kG))] w2 + E I b4 = 0, b = n pi / L. 0.1 %.
TEST(BeamClosedForms, simply_supported_timoshenko_beam) {
  const VectorXd f = deep_beam(80);
  const BeamProperties s = rectangle_section(steel, 2, 2);
  for (int n = 1; n <= 3; ++n) {
    const double beta2 = std::pow(n * pi / 10, 2);
    const double a = s.inertia_y * s.mass / s.GA_z;
    const double b = s.mass + beta2 * (s.inertia_y + s.EI_y * s.mass / s.GA_z);
    const double w2 = (b - std::sqrt(b * b - 4 * a * s.EI_y * beta2 * beta2)) / (2 * a);
    const double wanted = std::sqrt(w2) / (2 * pi);
    EXPECT_LT((f.array() / wanted - 1).abs().minCoeff(), 1e-3) << "n = " << n;
  }
}

// Roots of Euler's beam; shear rigid, without rotary inertia, 24 elements. 0.01 %.
TEST(BeamClosedForms, euler_beams) {
  BeamProperties section{.EA = 1e9, .EI_y = 100, .EI_z = 100, .GJ = 80, .mass = 2};
  struct Case {
    std::vector<int> left, right;
    std::vector<double> beta_L;
    int rigid;
  };
  const std::vector<int> clamped{2, 4}, pinned{2};
  for (const Case& c : {Case{clamped, {}, {1.87510, 4.69409, 7.85476}, 0},
                        Case{clamped, clamped, {4.73004, 7.85320, 10.99561, 14.13717}, 0},
                        Case{{}, {}, {4.73004, 7.85320, 10.99561, 14.13717}, 2},
                        Case{clamped, pinned, {3.92660, 7.06858}, 0}}) {
    Model model;
    const auto nodes = add_row(model, add_node(model, Vector3d::Zero()), {3, 0, 0}, 24, section);
    add_support(model, nodes, {0, 1, 3, 5}, "plane"); // bending in x-z alone
    add_support(model, {nodes.front()}, c.left, "left");
    add_support(model, {nodes.back()}, c.right, "right");
    const int count = c.rigid + static_cast<int>(c.beta_L.size());
    const VectorXd f = find_modes(model, count).hertz;
    for (std::size_t i = 0; i < c.beta_L.size(); ++i)
      expect_ratio(f[c.rigid + static_cast<Eigen::Index>(i)],
                   std::pow(c.beta_L[i] / 3, 2) * std::sqrt(100. / 2) / (2 * pi), 1e-4,
                   "beta L = " + std::to_string(c.beta_L[i]));
  }
}

// Thin ring, R = 0.1, t = 0.002: inextensional n (n2 - 1) / sqrt(n2 + 1) sqrt(EI / (m R4)) and
// breathing sqrt(E / rho) / R (Love; Blevins). 96 straight beams, 0.3 %.
TEST(BeamClosedForms, ring_bends_and_breathes) {
  constexpr double R = 0.1, t = 0.002, E = 210e9, rho = 7850;
  constexpr int n_beams = 96;
  const double EI = E * t * t * t / 12; // per unit width
  const BeamProperties section{.EA = E * t, .EI_y = EI, .EI_z = EI, .GJ = EI, .mass = rho * t};
  Model ring;
  for (int k = 0; k < n_beams; ++k)
    add_node(ring, R * Vector3d(std::cos(2 * pi * k / n_beams), 0, std::sin(2 * pi * k / n_beams)));
  for (int k = 0; k < n_beams; ++k) {
    ring.beams.push_back(
        {.node1 = k, .node2 = (k + 1) % n_beams, .section = section, .up = {0, 1, 0}});
    add_support(ring, {k}, {1, 3, 5}, "plane");
  }
  const VectorXd f = find_modes(ring, 9).hertz;
  const std::vector<double> source{127.53, 360.70, 691.6};
  for (int n = 2; n <= 4; ++n) {
    const double wanted = n * (n * n - 1) / std::sqrt(n * n + 1.) *
                          std::sqrt(EI / (rho * t * std::pow(R, 4))) / (2 * pi);
    expect_ratio(wanted, source[n - 2], 1e-4, "table");
    expect_ratio(f[2 * n - 1], wanted, 0.003, "n = " + std::to_string(n));
    expect_ratio(f[2 * n], wanted, 0.003, "n = " + std::to_string(n));
  }
  // Breathing: the mode that is radial and even all round; Rayleigh quotient of that motion.
  const System system = assemble(ring);
  VectorXd u = no_force(ring);
  for (int k = 0; k < n_beams; ++k) u.segment<3>(6 * k) = ring.mesh.nodes[k] / R;
  VectorXd q(system.map.size());
  for (int i = 0; i < system.map.size(); ++i) q[i] = u[system.map.full[i]];
  const double lambda =
      q.dot(symmetric_product(system.K, q).col(0)) / q.dot(symmetric_product(system.M, q).col(0));
  expect_ratio(frequency(lambda), std::sqrt(E / rho) / (2 * pi * R), 0.003, "breathing");
}

} // namespace

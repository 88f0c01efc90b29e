// Equilibrium beyond points where the load turns back, and shells at large rotation, against closed
// forms and published tables.
#include "solve/equilibrium_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace plica;

namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

struct Place {
  Vector3d x, director;
};

// A shell over [0, 1] x [0, 1].
template <class Map> Model mapped_shell(int along, int across, double thickness, Map map) {
  Model model;
  model.components = {"shell"};
  std::vector<Vector3d> directors;
  for (int j = 0; j <= across; ++j)
    for (int i = 0; i <= along; ++i) {
      const Place place = map(double(i) / along, double(j) / across);
      add_node(model, place.x);
      directors.push_back(place.director);
    }
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < along; ++i) {
      const int n = j * (along + 1) + i;
      ShellQuad quad;
      quad.nodes = {n, n + 1, n + along + 2, n + along + 1};
      for (int c = 0; c < 4; ++c) quad.directors.col(c) = directors[std::size_t(quad.nodes[c])];
      quad.thickness.setConstant(thickness);
      model.mesh.quads.push_back(quad);
    }
  return model;
}

void hold(Model& model, int node, std::initializer_list<int> dofs) {
  for (int dof : dofs) {
    const bool known =
        std::any_of(model.constraints.begin(), model.constraints.end(),
                    [&](const Constraint& c) { return c.node == node && c.dof == dof; });
    if (!known) model.constraints.push_back({node, dof, {}, "test"});
  }
}

// A value over the share of the loads, by the parabola through the points about.
struct Curve {
  std::vector<double> share, value;

  double at(double wanted) const {
    std::size_t i = 2;
    while (i + 1 < share.size() && share[i] < wanted) ++i;
    double sum = 0;
    for (std::size_t j = i - 2; j <= i; ++j) {
      double weight = 1;
      for (std::size_t k = i - 2; k <= i; ++k)
        if (k != j) weight *= (wanted - share[k]) / (share[j] - share[k]);
      sum += weight * value[j];
    }
    return sum;
  }
};

struct Enough {};

} // namespace

// A bar from a pin to a slider at height h, pressed down by P: P = E A (L0 - L) / L0 (h - w) / L
// with the strain of the length (half of von Mises' truss). It snaps through, and beyond it all of
// the load is borne.
TEST(EquilibriumPath, SnapsThroughAsVonMisesTruss) {
  const double b = 1, h = 0.2, EA = 1e6, L0 = std::hypot(b, h);
  const auto force = [&](double w) {
    const double L = std::hypot(b, h - w);
    return EA * (L0 - L) / L0 * (h - w) / L;
  };
  double limit = 0;
  for (int i = 0; i < 10000; ++i) limit = std::max(limit, force(h * i / 10000));
  Model model;
  model.components = {"bar"};
  BeamProperties section = rectangle_section({.E = 1e6, .nu = 0.3, .rho = 1}, 1, 1);
  add_node(model, {0, 0, 0});
  add_node(model, {b, 0, h});
  model.beams.push_back({.node1 = 0, .node2 = 1, .section = section, .up = {0, 1, 0}});
  ASSERT_NEAR(section.EA, EA, 1e-6 * EA);
  hold(model, 0, {0, 1, 2, 3, 5});
  hold(model, 1, {0, 1, 3, 5});
  StateLoads loads;
  loads.force = VectorXd::Zero(12);
  loads.force[6 + 2] = -1.5 * limit;
  int unstable = 0;
  const PathResult path =
      follow_state(model, loads,
                   [&](const PathPoint& point) {
                     const double w = h - (*point.nodes)[1].z();
                     EXPECT_NEAR(1.5 * limit * point.share, force(w), 1e-6 * limit) << w;
                     // The slope of the force says whether it is stable.
                     const double slope = force(w + 1e-6) - force(w - 1e-6);
                     if (std::abs(slope) > 1e-4 * EA * 1e-6) {
                       EXPECT_EQ(point.negative > 0, slope < 0) << w;
                     }
                     unstable += point.negative > 0;
                   },
                   {.first_share = 0.02, .most_points = 400});
  EXPECT_GT(unstable, 3);
  EXPECT_NEAR(path.turned_at * 1.5, 1, 0.01);
  EXPECT_GT(h - path.state.model.mesh.nodes[1].z(), 2 * h);
  EXPECT_NEAR(force(h - path.state.model.mesh.nodes[1].z()), 1.5 * limit, 1e-6 * limit);
}

// An arch of 215 degrees, clamped at one end and hinged at the other, under a load at its crown
// turns back at 8.97 EI / R^2: DaDeppo & Schmidt, J. Appl. Mech. 42 (1975) 853-857.
TEST(EquilibriumPath, DeepArch) {
  const double R = 100, EI = 1e6;
  const int elements = 120; // straight ones: the error is 2.5 % at 60, 0.6 % here
  Model model;
  model.components = {"arch"};
  BeamProperties section = rectangle_section({.E = 1.2e7, .nu = 0, .rho = 1}, 1, 1);
  ASSERT_NEAR(section.EI_y, EI, 1e-9 * EI);
  section.GA_y = section.GA_z = std::numeric_limits<double>::infinity();
  section.EA *= 100; // its closed form does not stretch
  for (int i = 0; i <= elements; ++i) {
    const double a = (215. * i / elements - 107.5) * M_PI / 180;
    add_node(model, {R * std::sin(a), 0, R * std::cos(a)});
    for (int dof : {1, 3, 5}) hold(model, i, {dof});
  }
  for (int i = 0; i < elements; ++i)
    model.beams.push_back({.node1 = i, .node2 = i + 1, .section = section, .up = {0, 1, 0}});
  hold(model, 0, {0, 2, 4});
  hold(model, elements, {0, 2});
  StateLoads loads;
  loads.force = VectorXd::Zero(dof_count(model));
  loads.force[6 * (elements / 2) + 2] = -1000;
  double largest = 0, last = 0;
  try {
    follow_state(model, loads,
                 [&](const PathPoint& point) {
                   largest = std::max(largest, 1000 * point.share);
                   if (1000 * point.share < last) throw Enough();
                   last = 1000 * point.share;
                 },
                 {.first_share = 0.05, .most_points = 300});
    FAIL() << "the load does not turn back";
  } catch (const Enough&) {
    EXPECT_NEAR(largest / 897, 1, 0.01);
  }
}

// Deflections of a hemisphere with a hole of 18 degrees, pinched at four points of its edge, where
// it is pulled and where it is pushed; n x n quads on a quarter.
Eigen::Vector2d pinched_hemisphere(int n, double force) {
  Model model = mapped_shell(n, n, 0.04, [](double u, double v) {
    const double around = u * M_PI / 2, up = v * 72 * M_PI / 180;
    const Vector3d normal(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around),
                          std::sin(up));
    return Place{10 * normal, normal};
  });
  model.shells.push_back({{.E = 6.825e7, .nu = 0.3, .rho = 1}, MembraneStrain::mitc4_plus, 0});
  for (int j = 0; j <= n; ++j) {
    hold(model, j * (n + 1), {1, 3, 5});     // plane y = 0
    hold(model, j * (n + 1) + n, {0, 4, 5}); // plane x = 0
  }
  hold(model, 0, {2}); // nothing else holds it along its axis
  StateLoads loads;
  loads.force = VectorXd::Zero(dof_count(model));
  loads.force[0] = force / 2; // half of each point lies in the quarter
  loads.force[6 * n + 1] = -force / 2;
  const PathResult path =
      follow_state(model, loads, [](const PathPoint&) {}, {.first_share = 0.1, .most_points = 200});
  const auto& nodes = path.state.model.mesh.nodes;
  return {nodes[0].x() - 10, 10 - nodes[std::size_t(n)].y()};
}

// Sze, Liu & Lo, Finite Elem. Anal. Des. 40 (2004) 1551-1569, sec. 3.4: R = 10, h = 0.04,
// E = 6.825e7, nu = 0.3, P = 400, of 16 x 16 quads as there. With the incompatible
// membrane of 18 x 18 quads 3 % are missing.
TEST(LargeRotation, PinchedHemisphere) {
  const Eigen::Vector2d u = pinched_hemisphere(16, 400);
  EXPECT_NEAR(u[0] / 4.067, 1, 0.01);
  EXPECT_NEAR(u[1] / 8.178, 1, 0.01);
}

// An open cylinder pulled apart at two points: Sze, Liu & Lo, sec. 3.5: R = 4.953, L = 10.35,
// h = 0.094, E = 10.5e6, nu = 0.3125, P_max = 40000; deflection under the load.
TEST(LargeRotation, CylinderPulledApart) {
  const int along = 16, around = 24;
  Model model = mapped_shell(along, around, 0.094, [](double u, double v) {
    const double a = v * M_PI / 2;
    const Vector3d normal(std::sin(a), 0, std::cos(a));
    return Place{4.953 * normal - Vector3d(0, u * 10.35 / 2, 0), normal};
  });
  model.shells.push_back({{.E = 10.5e6, .nu = 0.3125, .rho = 1}, MembraneStrain::incompatible, 0});
  const auto number = [&](int i, int j) { return j * (along + 1) + i; };
  for (int j = 0; j <= around; ++j) hold(model, number(0, j), {1, 3, 5}); // plane y = 0
  for (int i = 0; i <= along; ++i) {
    hold(model, number(i, 0), {0, 4, 5});      // plane x = 0
    hold(model, number(i, around), {2, 3, 4}); // plane z = 0
  }
  StateLoads loads;
  loads.force = VectorXd::Zero(dof_count(model));
  loads.force[2] = 10000; // a quarter of the point lies in the octant
  Curve under;
  follow_state(model, loads,
               [&](const PathPoint& point) {
                 under.share.push_back(point.share);
                 under.value.push_back((*point.nodes)[0].z() - 4.953);
               },
               {.first_share = 0.004, .most_points = 300, .longest = 1});
  for (const auto& [share, w] : {std::pair{0.05, 1.260},
                                 {0.1, 1.707},
                                 {0.25, 2.180},
                                 {0.5, 2.473},
                                 {0.75, 2.692},
                                 {1., 2.768}})
    EXPECT_NEAR(under.at(share) / w, 1, 0.01) << share;
}

// A roof over an arc of 0.2 rad, its straight edges hinged, its curved ones free, under a load at
// its middle; n x n quads on a quarter. The deflection under the load, as far as is asked for, and
// the share of the load.
Curve hinged_roof(int n, double thickness, double load, double first_share, double far) {
  const double R = 2540, half_length = 254, half_angle = 0.1;
  Model model = mapped_shell(n, n, thickness, [&](double u, double v) {
    const Vector3d normal(std::sin(v * half_angle), 0, std::cos(v * half_angle));
    return Place{R * normal - Vector3d(0, u * half_length, 0), normal};
  });
  model.shells.push_back({{.E = 3102.75, .nu = 0.3, .rho = 1}, MembraneStrain::incompatible, 0});
  for (int j = 0; j <= n; ++j) hold(model, j * (n + 1), {1, 3, 5}); // plane y = 0
  for (int i = 0; i <= n; ++i) {
    hold(model, i, {0, 4, 5});               // plane x = 0
    hold(model, n * (n + 1) + i, {0, 1, 2}); // hinged
  }
  StateLoads loads;
  loads.force = VectorXd::Zero(dof_count(model));
  loads.force[2] = -load / 4;
  Curve path;
  try {
    follow_state(model, loads,
                 [&](const PathPoint& point) {
                   path.share.push_back(R - (*point.nodes)[0].z());
                   path.value.push_back(point.share);
                   if (path.share.back() > far) throw Enough();
                 },
                 {.first_share = first_share, .most_points = 400, .longest = 1});
  } catch (const Enough&) {
  }
  return path;
}

// How far a point lies off a curve: in its load, against the limit, or, where the curve is steep,
// in its deflection.
double off(const Curve& path, double deflection, double share, double limit) {
  const double load = std::abs(path.at(deflection) - share);
  const double slope = (path.at(1.01 * deflection) - path.at(0.99 * deflection)) / 0.02;
  return std::min(load / limit, load / std::abs(slope));
}

// Sze, Liu & Lo, sec. 3.8, table 9: R = 2540, 508 long, 12.7 thick, E = 3102.75, nu = 0.3. The
// whole curve, which turns back and rises again; loads of P_max = 3000.
TEST(EquilibriumPath, HingedRoofSnapsThrough) {
  const Curve path = hinged_roof(12, 12.7, 3000, 0.06, 28.5);
  const double limit = 0.7421;
  for (const auto& [share, deflection] : {std::pair{0.1980, 1.638},
                                          {0.4686, 4.477},
                                          {0.6908, 8.237},
                                          {limit, 11.293},
                                          {0.6649, 13.583},
                                          {0.5055, 15.217},
                                          {0.3245, 16.590},
                                          {0.1729, 19.852},
                                          {0.2950, 22.875},
                                          {0.5093, 25.293},
                                          {0.8549, 27.964}})
    EXPECT_LT(off(path, deflection, share, limit), 0.01) << deflection;
}

// The same of half the thickness turns back in its deflection, too: the loads between which it
// does.
TEST(EquilibriumPath, ThinHingedRoofSnapsBack) {
  const Curve path = hinged_roof(12, 6.35, 3000, 0.015, 18.5);
  const auto lowest = std::min_element(path.value.begin(), path.value.end());
  EXPECT_NEAR(*std::max_element(path.value.begin(), lowest) / 0.1953, 1, 0.01);
  EXPECT_NEAR(*lowest / -0.1288, 1, 0.01);
  EXPECT_FALSE(std::is_sorted(path.share.begin(), path.share.end()));
}

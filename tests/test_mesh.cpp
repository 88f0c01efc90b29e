// The mesh of a bellows against the geometry of its drawing: lengths, tangents, exact directors,
// named sets, area, quality, and the file that Gmsh reads back.
#include "tests/bellows_case.hpp"

#include "mesh/generation/msh_file.hpp"
#include "mesh/generation/revolve.hpp"
#include "mesh/plate.hpp"
#include "tests/support/temporary_folder.hpp"

#include <Eigen/Geometry>
#include <filesystem>
#include <gmsh.h>
#include <numbers>
#include <set>

namespace plica::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr double exact = 1e-12;
const Convolution u_shape{.height = 9e-3, .pitch = 6e-3, .root_arc = 1.2e-3, .crown_arc = 1.8e-3};
const Convolution omega{.height = 9e-3, .pitch = 6e-3, .root_arc = 1.5e-3, .crown_arc = 2.0e-3};
const Convolution leaning{.height = 9e-3, .pitch = 8e-3, .root_arc = 1.2e-3, .crown_arc = 1.8e-3};

Meridian bellows(const Convolution& shape, const MeridianDensity& density = {4, 5}) {
  Meridian meridian(0.01, 0.03);
  meridian.add_cuff(5e-3, 0.03, 2);
  for (int k = 0; k < 2; ++k) meridian.add_convolution(shape, density);
  meridian.add_cuff(4e-3, 0.03, 3);
  return meridian;
}

Mesh mesh_of(const Meridian& meridian, int around = 12) {
  return revolve(meridian, around, [](double) { return 1e-3; });
}

// Exact angle of an arc between its ends, without sign.
double angle_of(const MeridianCurve& arc) {
  const Vector2d a = arc.start - arc.centre, b = arc.end - arc.centre;
  return std::acos(a.dot(b) / (a.norm() * b.norm()));
}

// Area of the surface of revolution by Pappus, 2 pi times the first moment of the curve.
double exact_area(const Meridian& meridian) {
  double area = 0;
  for (const MeridianCurve& c : meridian.curves()) {
    const Vector2d chord = c.end - c.start;
    area += c.kind == CurveKind::line
                ? pi * (c.start.y() + c.end.y()) * chord.norm()
                : 2 * pi * (c.start - c.centre).norm() *
                      (c.centre.y() * angle_of(c) +
                       std::abs(chord.x()) * ((c.start + c.end).y() / 2 > c.centre.y() ? 1 : -1));
  }
  return area;
}

TEST(Meridian, half_convolution_meets_both_equations_of_the_drawing) {
  for (const Convolution& c : {u_shape, omega, leaning}) {
    const auto [phi, wall] = half_convolution(c);
    const double a = c.root_arc + c.crown_arc;
    EXPECT_NEAR(a * std::sin(phi) + wall * std::cos(phi), c.pitch / 2, 1e-15);
    EXPECT_NEAR(-a * std::cos(phi) + wall * std::sin(phi), c.height - a, 1e-15);
  }
  EXPECT_NEAR(half_convolution(u_shape).angle, pi / 2, exact);
  EXPECT_NEAR(half_convolution(u_shape).wall, 6e-3, 1e-15);
  EXPECT_GT(half_convolution(omega).angle, pi / 2 + 0.05);
  EXPECT_LT(half_convolution(leaning).angle, pi / 2 - 0.05);
  EXPECT_THROW(
      half_convolution({.height = 2e-3, .pitch = 6e-3, .root_arc = 3e-3, .crown_arc = 3e-3}),
      std::invalid_argument);
}

TEST(Meridian, curves_have_the_lengths_and_places_of_the_drawing) {
  for (const Convolution& c : {u_shape, omega, leaning}) {
    const Meridian meridian = bellows(c);
    const auto [phi, wall] = half_convolution(c);
    EXPECT_NEAR(meridian.y(), 0.01 + 5e-3 + 2 * c.pitch + 4e-3, exact);
    EXPECT_NEAR(meridian.radius(), 0.03, exact);
    ASSERT_EQ(meridian.convolutions(), 2);
    ASSERT_EQ(meridian.curves().size(), 14u);
    for (std::size_t i = 0; i < 12; ++i) {
      const MeridianCurve& curve = meridian.curves()[i + 1];
      const bool is_wall = i % 3 == 1, crown = i % 6 == 2 || i % 6 == 3;
      EXPECT_EQ(curve.kind, is_wall ? CurveKind::line : CurveKind::arc);
      EXPECT_EQ(curve.convolution, i < 6 ? 1 : 2);
      if (is_wall) {
        EXPECT_NEAR((curve.end - curve.start).norm(), wall, exact);
        continue;
      }
      const double radius = crown ? c.crown_arc : c.root_arc;
      EXPECT_NEAR((curve.start - curve.centre).norm(), radius, exact);
      EXPECT_NEAR((curve.end - curve.centre).norm(), radius, exact);
      EXPECT_NEAR(angle_of(curve), phi, 1e-9);
    }
    EXPECT_NEAR(meridian.curves()[3].end.y(), 0.03 + c.height, exact) << "crown";
    EXPECT_TRUE(meridian.curves()[3].ends_at_crown);
  }
}

TEST(Meridian, arcs_and_walls_join_with_one_tangent) {
  for (const Convolution& c : {u_shape, omega, leaning}) {
    const auto curves = mesh_meridian(bellows(c));
    ASSERT_GT(curves.size(), 1U);
    for (std::size_t i = 1; i < curves.size(); ++i) {
      EXPECT_LT((curves[i - 1].back().position - curves[i].front().position).norm(), exact);
      EXPECT_LT((curves[i - 1].back().normal - curves[i].front().normal).norm(), 1e-9)
          << "joint " << i;
    }
  }
}

TEST(Meridian, discs_and_straight_points_keep_both_normals_at_a_kink) {
  Meridian discs(0, 0.03);
  discs.add_disc(8e-3, 4e-3, {4, 5});
  const auto sides = mesh_meridian(discs);
  ASSERT_EQ(sides.size(), 2u);
  const Vector2d up(-8e-3, 2e-3), down(8e-3, 2e-3); // left normals of (2, 8) and (2, -8) mm
  EXPECT_LT((sides[0].back().normal - up.normalized()).norm(), exact);
  EXPECT_LT((sides[1].front().normal - down.normalized()).norm(), exact);
  const Mesh mesh = mesh_of(discs);
  const ShellQuad& left = mesh.quads[4 * 12];  // last belt before the crown
  const ShellQuad& right = mesh.quads[5 * 12]; // first after it
  EXPECT_EQ(left.nodes[1], right.nodes[0]) << "one node";
  EXPECT_LT(left.directors.col(1).dot(right.directors.col(0)), 0) << "two directors";

  Meridian points(0, 0.03);
  points.add_points({{0, 0.03}, {2e-3, 0.036}, {4e-3, 0.036}, {6e-3, 0.03}}, false, {4, 3});
  const auto stretches = mesh_meridian(points);
  ASSERT_EQ(stretches.size(), 3u);
  EXPECT_LT((stretches[1].front().normal - Vector2d(0, 1)).norm(), exact);
  EXPECT_GT((stretches[0].back().normal - stretches[1].front().normal).norm(), 0.5);
}

TEST(Meridian, a_smooth_profile_runs_through_its_points_with_turning_normals) {
  std::vector<Vector2d> points; // half a circle of radius 3 mm on the pipe
  for (int i = 0; i <= 24; ++i)
    points.emplace_back(3e-3 - 3e-3 * std::cos(pi * i / 24), 0.03 + 3e-3 * std::sin(pi * i / 24));
  Meridian meridian(0.02, 0.03);
  meridian.add_points(points, true, {6, 6});
  const auto curves = mesh_meridian(meridian);
  ASSERT_EQ(curves.size(), 1u);
  ASSERT_EQ(curves[0].size(), 4u * 6 + 2 * 6 + 1);
  const Vector2d centre(0.02 + 3e-3, 0.03);
  for (std::size_t i = 1; i + 1 < curves[0].size(); ++i) {
    const Vector2d out = curves[0][i].position - centre;
    EXPECT_NEAR(out.norm(), 3e-3, 2e-6);
    EXPECT_GT(curves[0][i].normal.dot(out.normalized()), 0.999) << "node " << i;
  }
}

// The belts of quads of one curve, as revolve() lays them.
struct Belt {
  const MeridianCurve* curve;
  std::size_t first_quad;
};

std::vector<Belt> belts(const Meridian& meridian, int around) {
  std::vector<Belt> belts;
  const auto points = mesh_meridian(meridian);
  for (std::size_t k = 0; k < points.size(); ++k)
    for (std::size_t i = 1; i < points[k].size(); ++i)
      belts.push_back({&meridian.curves()[k], belts.size() * around});
  return belts;
}

// Outward unit normal of the drawn surface at a point on it.
Vector3d drawn_normal(const MeridianCurve& curve, const Vector3d& x) {
  const double r = std::hypot(x.x(), x.z());
  const Vector2d along = (curve.end - curve.start).normalized();
  Vector2d normal(-along.y(), along.x());
  if (curve.kind == CurveKind::arc) {
    const double side = ((curve.start + curve.end) / 2 - curve.centre).dot(normal) > 0 ? 1 : -1;
    normal = side * (Vector2d(x.y(), r) - curve.centre).normalized();
  }
  return {normal.y() * x.x() / r, normal.x(), normal.y() * x.z() / r};
}

TEST(Directors, are_exact_on_torus_cylinder_and_plane) {
  constexpr int around = 12;
  for (const Convolution& c : {u_shape, omega, leaning}) {
    const Meridian meridian = bellows(c);
    const Mesh mesh = mesh_of(meridian, around);
    const auto all = belts(meridian, around);
    ASSERT_EQ(all.size() * around, mesh.quads.size());
    for (const Belt& belt : all)
      for (int j = 0; j < around; ++j) {
        const ShellQuad& q = mesh.quads[belt.first_quad + j];
        for (int i = 0; i < 4; ++i)
          ASSERT_LT((q.directors.col(i) - drawn_normal(*belt.curve, mesh.nodes[q.nodes[i]])).norm(),
                    1e-11);
        const Vector3d diagonal = mesh.nodes[q.nodes[2]] - mesh.nodes[q.nodes[0]];
        const Vector3d other = mesh.nodes[q.nodes[3]] - mesh.nodes[q.nodes[1]];
        EXPECT_GT(diagonal.cross(other).dot(q.directors.rowwise().mean()), 0) << "turns right";
      }
  }
}

double area_of(const Mesh& mesh) {
  double area = 0;
  for (const ShellQuad& q : mesh.quads) {
    const Vector3d d = mesh.nodes[q.nodes[2]] - mesh.nodes[q.nodes[0]];
    area += d.cross(mesh.nodes[q.nodes[3]] - mesh.nodes[q.nodes[1]]).norm() / 2;
  }
  return area;
}

TEST(Area, converges_to_the_theorem_of_pappus_at_order_two) {
  for (const Convolution& c : {u_shape, omega, leaning}) {
    const double exact_value = exact_area(bellows(c));
    std::array<double, 3> error{};
    for (int k = 0; k < 3; ++k) {
      const int factor = 1 << k;
      const Meridian meridian = bellows(c, {3 * factor, 2 * factor});
      error[k] = 1 - area_of(mesh_of(meridian, 16 * factor)) / exact_value;
    }
    EXPECT_LT(error[2], 2e-3);
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(std::log2(error[k] / error[k + 1]), 2, 0.1);
  }
}

TEST(Sets, name_ends_convolutions_crowns_roots_and_cuffs) {
  constexpr int around = 12;
  const Mesh mesh = mesh_of(bellows(u_shape), around);
  const auto radius = [&](int n) { return std::hypot(mesh.nodes[n].x(), mesh.nodes[n].z()); };
  const auto expect_circle = [&](const std::string& name, double y, double r) {
    ASSERT_TRUE(mesh.sets.contains(name)) << name;
    const auto& nodes = mesh.sets.at(name);
    EXPECT_EQ(nodes.size(), std::size_t(around)) << name;
    for (int n : nodes) {
      EXPECT_NEAR(mesh.nodes[n].y(), y, exact) << name;
      EXPECT_NEAR(radius(n), r, exact) << name;
    }
  };
  expect_circle("left", 0.010, 0.03);
  expect_circle("right", 0.031, 0.03);
  expect_circle("root[1]", 0.015, 0.03);
  expect_circle("crown[1]", 0.018, 0.039);
  expect_circle("root[2]", 0.021, 0.03);
  expect_circle("crown[2]", 0.024, 0.039);
  expect_circle("root[3]", 0.027, 0.03);
  EXPECT_EQ(mesh.sets.at("cuff.left").size(), 3u * around);
  EXPECT_EQ(mesh.sets.at("cuff.right").size(), 4u * around);
  EXPECT_EQ(mesh.sets.at("all").size(), mesh.nodes.size());
  for (int k : {1, 2})
    for (int n : mesh.sets.at("convolution[" + std::to_string(k) + "]")) {
      EXPECT_GT(mesh.nodes[n].y(), 0.015 + (k - 1) * 6e-3 - 1e-9);
      EXPECT_LT(mesh.nodes[n].y(), 0.015 + k * 6e-3 + 1e-9);
    }
}

TEST(Quality, is_that_of_known_elements) {
  const Mesh square = mesh_plate({{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}}}, 2, 1, 0.1);
  const MeshQuality q = mesh_quality(square);
  EXPECT_NEAR(q.max_aspect, 2, exact);
  EXPECT_NEAR(q.min_jacobian, 1, exact);
  EXPECT_NEAR(q.max_warp, 0, exact);
  // One corner lifted by 0.1: all four lie 0.025 off their mean plane.
  const Mesh warped = mesh_plate({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}}}, 1, 1, 0.1);
  EXPECT_NEAR(mesh_quality(warped).max_warp, 0.025, 2e-4);
  // Folded: corner 3 pulled over the diagonal.
  const Mesh folded = mesh_plate({{{0, 0, 0}, {1, 0, 0}, {0.2, 0.2, 0}, {0, 1, 0}}}, 1, 1, 0.1);
  EXPECT_LT(mesh_quality(folded).min_jacobian, 0);
  EXPECT_LT(mesh_quality(mesh_of(bellows(u_shape))).max_warp, 1e-9) << "trapezoids are flat";
}

TEST(Thinning, follows_its_law_with_the_radius) {
  const auto law = [](double r) { return 1e-3 * 0.03 / r; };
  const Mesh mesh = revolve(bellows(u_shape), 8, law);
  for (const ShellQuad& q : mesh.quads)
    for (int i = 0; i < 4; ++i) {
      const Vector3d& x = mesh.nodes[q.nodes[i]];
      EXPECT_NEAR(q.thickness[i], law(std::hypot(x.x(), x.z())), 1e-15);
    }
  Case data = verification_case("bellows_a", {16, 2, 3});
  Bellows& part = bellows_of(data);
  const double root = part.root_radius, t = part.wall.plies[0];
  const auto thickest_and_thinnest = [&] {
    double low = 1, high = 0;
    for (const ShellQuad& q : bellows_mesh(part, bellows_meridian(part)).quads) {
      low = std::min(low, q.thickness.minCoeff());
      high = std::max(high, q.thickness.maxCoeff());
    }
    return std::pair(low, high);
  };
  part.wall.thinning = Thinning::uniform; // EJMA: t sqrt(Db / Dm)
  const double height = part.profile[0].height;
  const auto [low, high] = thickest_and_thinnest();
  EXPECT_DOUBLE_EQ(low, high);
  EXPECT_NEAR(low, t * std::sqrt(root / (root + height / 2)), 1e-15);
  part.wall.thinning = Thinning::local;
  const auto [crown, foot] = thickest_and_thinnest();
  EXPECT_NEAR(foot, t, 1e-12);
  EXPECT_NEAR(crown, t * std::pow(root / (root + height), part.wall.thinning_exponent), 1e-12);
}

TEST(MshFile, is_read_back_by_gmsh_with_nodes_quads_and_sets) {
  const Mesh mesh = mesh_of(bellows(u_shape), 8);
  const test::TemporaryFolder folder("mesh");
  const auto file = folder.path / "mesh.msh";
  write_msh(mesh, {{0, 1}}, file);
  gmsh::initialize();
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::open(file.string());
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters);
  std::set<std::string> groups;
  gmsh::vectorpair entities;
  gmsh::model::getPhysicalGroups(entities);
  for (const auto& [dim, tag] : entities) {
    std::string name;
    gmsh::model::getPhysicalName(dim, tag, name);
    groups.insert(name);
  }
  std::vector<std::size_t> quads, corners;
  gmsh::model::mesh::getElementsByType(3, quads, corners);
  gmsh::finalize();
  EXPECT_EQ(std::set(tags.begin(), tags.end()).size(), mesh.nodes.size());
  EXPECT_EQ(quads.size(), mesh.quads.size());
  for (const char* name : {"left", "right", "crown[1]", "root[3]", "cuff.left"})
    EXPECT_TRUE(groups.contains(name)) << name;
  double largest = 0;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const Eigen::Map<const Vector3d> x(&coordinates[3 * i]);
    largest = std::max(largest, nearest_node(mesh, x).second);
  }
  EXPECT_LT(largest, 1e-14);
}

} // namespace
} // namespace plica::test

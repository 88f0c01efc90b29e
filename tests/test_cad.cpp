// Parts from CAD files and triangles: against the same shapes made from their profile or corners.
#include "tests/cad_samples.hpp"

#include "io/input/case_file.hpp"
#include "mesh/generation/surface_file.hpp"
#include "mesh/generation/surface_mesher.hpp"
#include "model/shape/build_bellows.hpp"
#include "model/shape/build_surface.hpp"
#include "run/analyses/run.hpp"
#include "tests/bellows_case.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace plica::test {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

class Cad : public testing::Test {
protected:
  fs::path at(const std::string& name) const { return folder_.path / name; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(at(name), std::ios::binary) << text;
  }
  // What is said of a case with such a part.
  std::string refusal(const std::string& part) const {
    write("case.yaml", "case: c\nmaterials: {steel: {E: 200 GPa, nu: 0.3, rho: 7850 kg/m3}}\n"
                       "parts:\n  s: {type: surface, material: steel, thickness: 1 mm, " +
                           part +
                           "}\ncaps: {a: {of: 's.edge[1]'}}\nmount: {a: rigid}\nanalyses: {static: "
                           "false, modes: {count: 2}}\n");
    return error_of([&] { build(read_case(at("case.yaml").string()).data); });
  }

private:
  const TemporaryFolder folder_{"cad"};
};

double area(const Mesh& mesh) {
  double sum = 0;
  for (const ShellQuad& q : mesh.quads) {
    const auto x = [&](int i) { return mesh.nodes[std::size_t(q.nodes[std::size_t(i)])]; };
    sum += (x(2) - x(0)).cross(x(3) - x(1)).norm() / 2;
  }
  return sum;
}

// Bellows A of the verification, its profile revolved, written and read as STEP: within 1 % of the
// bellows made from the profile, whose mesh has 1 % of its own.
TEST_F(Cad, a_bellows_from_step_vibrates_as_that_from_its_profile) {
  Case drawn = verification_case("bellows_a", {}, 10);
  const std::string material = bellows_of(drawn).material;
  const Results own = run_silently(drawn);
  write_revolved(bellows_meridian(bellows_of(drawn)), at("bellows.step"));
  Case data = drawn;
  data.parts = {{"bellows", SurfacePart{.material = material,
                                        .file = at("bellows.step").string(),
                                        .thickness = 0.3e-3,
                                        .size = 2e-3,
                                        .turn = 0.4}}};
  data.caps[0].of = {"bellows.edge[1]"};
  data.caps[1].of = {"bellows.edge[2]"};
  const Results read = run_silently(data);
  EXPECT_NEAR(read.model.mass, own.model.mass, 0.005 * own.model.mass);
  ASSERT_GE(read.modes.size(), 5u);
  for (std::size_t m = 0; m < 5; ++m)
    compare("bellows A from STEP", "mode " + std::to_string(m + 1), read.modes[m].frequency,
            own.modes[m].frequency, 0.01);
  EXPECT_TRUE(read.verification.passed);
}

TEST_F(Cad, faces_that_touch_share_their_nodes) {
  const BracketOnPipe shape;
  write_bracket_on_pipe(shape, at("pipe.step"));
  const SurfaceFaces quads = mesh_surface_file(at("pipe.step"), {.size = 8e-3});
  const Mesh mesh = shell_mesh(quads, 1.5e-3, WallSide::middle);
  std::map<std::pair<int, int>, int> edges;
  for (const ShellQuad& q : mesh.quads)
    for (std::size_t i = 0; i < 4; ++i) {
      const int a = q.nodes[i], b = q.nodes[(i + 1) % 4];
      ++edges[{std::min(a, b), std::max(a, b)}];
    }
  double along = 0; // length of the edges at which three quads meet
  for (const auto& [edge, count] : edges)
    if (count == 3)
      along += (mesh.nodes[std::size_t(edge.first)] - mesh.nodes[std::size_t(edge.second)]).norm();
  EXPECT_NEAR(along, 1e-3 * (shape.to - shape.from), 1e-6);
  const double pi = std::numbers::pi;
  const double exact =
      1e-6 * (2 * pi * shape.radius * shape.length + shape.height * (shape.to - shape.from) -
              pi * shape.hole * shape.hole);
  EXPECT_NEAR(area(mesh), exact, 0.01 * exact);
  // Both ends of the pipe, the three free sides of the bracket, its hole.
  ASSERT_TRUE(mesh.sets.contains("edge[4]"));
  EXPECT_FALSE(mesh.sets.contains("edge[5]"));
  for (int node : mesh.sets.at("edge[1]")) EXPECT_NEAR(mesh.nodes[std::size_t(node)].y(), 0, 1e-9);
  for (int node : mesh.sets.at("edge[4]"))
    EXPECT_NEAR(mesh.nodes[std::size_t(node)].y(), 0.2, 1e-9);
}

TEST_F(Cad, an_outer_surface_is_moved_to_the_middle_of_its_wall) {
  Meridian tube(0, 0.05);
  tube.add_cuff(0.1, 0.05, 4);
  write_revolved(tube, at("tube.step"));
  for (const auto& [side, radius] :
       {std::pair{WallSide::outer, 0.049}, {WallSide::middle, 0.05}, {WallSide::inner, 0.051}}) {
    const Mesh mesh = shell_mesh(mesh_surface_file(at("tube.step"), {.size = 5e-3}), 2e-3, side);
    ASSERT_FALSE(mesh.quads.empty());
    for (const Vector3d& x : mesh.nodes) EXPECT_NEAR(std::hypot(x.x(), x.z()), radius, 1e-7);
    for (const ShellQuad& q : mesh.quads)
      for (int c = 0; c < 4; ++c) {
        const Vector3d& x = mesh.nodes[std::size_t(q.nodes[std::size_t(c)])];
        EXPECT_NEAR(q.directors.col(c).dot(Vector3d(x.x(), 0, x.z()).normalized()), 1, 1e-6);
      }
  }
}

// The same tube as IGES and as BREP: its area, its radius, its two ends.
TEST_F(Cad, iges_and_brep_are_read_as_step_is) {
  constexpr double radius = 0.03, length = 0.2;
  write_iges_tube(1e3 * radius, 1e3 * length, at("tube.igs"));
  Meridian meridian(0, radius);
  meridian.add_cuff(length, radius, 1);
  write_revolved(meridian, at("tube.brep"));
  write_revolved(meridian, at("tube.step"));
  for (const char* name : {"tube.igs", "tube.brep", "tube.step"}) {
    const Mesh mesh =
        shell_mesh(mesh_surface_file(at(name), {.unit = 1e-3, .size = 8e-3, .turn = 0.1}), 1e-3,
                   WallSide::middle);
    EXPECT_NEAR(area(mesh) / (2 * std::numbers::pi * radius * length), 1, 2e-3) << name;
    for (const Vector3d& x : mesh.nodes)
      EXPECT_NEAR(std::hypot(x.x(), x.z()), radius, 1e-8) << name;
    EXPECT_TRUE(mesh.sets.contains("edge[2]")) << name;
    EXPECT_FALSE(mesh.sets.contains("edge[3]")) << name;
  }
}

// A plate of triangles beside the same plate by its corners, both free.
TEST_F(Cad, a_plate_of_triangles_vibrates_as_that_from_its_corners) {
  write_stl_plate(300, 200, 6, at("plate.stl"));
  Case data;
  data.name = "plate";
  data.materials["steel"] = {200e9, 0.3, 7850};
  data.parts = {{"plate", Plate{.material = "steel",
                                .corners = {{{0, 0, 0}, {0.3, 0, 0}, {0.3, 0.2, 0}, {0, 0.2, 0}}},
                                .thickness = 2e-3,
                                .elements = {36, 24}}}};
  data.analyses.modes = Modes{.count = 10};
  const Results own = run_silently(data);
  SurfacePart triangles{.material = "steel",
                        .file = at("plate.stl").string(),
                        .unit = 1e-3,
                        .thickness = 2e-3,
                        .size = 8e-3};
  data.parts = {{"plate", triangles}};
  const Results read = run_silently(data);
  EXPECT_NEAR(read.model.mass, own.model.mass, 1e-6 * own.model.mass);
  ASSERT_EQ(read.modes.size(), 10u);
  for (std::size_t m = 6; m < 10; ++m)
    compare("plate", "free mode " + std::to_string(m - 5), read.modes[m].frequency,
            own.modes[m].frequency, 0.01);
  const Mesh mesh = surface_mesh(triangles);
  EXPECT_TRUE(mesh.sets.contains("edge[1]"));
  EXPECT_FALSE(mesh.sets.contains("edge[2]"));
  // As they are in the file, a finer one: shells of three nodes.
  write_stl_plate(300, 200, 24, at("fine.stl"));
  triangles.file = at("fine.stl").string();
  triangles.size = 0;
  data.parts = {{"plate", triangles}};
  const Results as_they_are = run_silently(data);
  EXPECT_TRUE(as_they_are.mesh.quads.empty());
  EXPECT_FALSE(as_they_are.mesh.triangles.empty());
  for (std::size_t m = 6; m < 10; ++m)
    compare("plate of triangles", "free mode " + std::to_string(m - 5),
            as_they_are.modes[m].frequency, own.modes[m].frequency, 0.01);
}

// A closed tube of few facets, meshed anew with elements of several sizes, clamped at one end,
// beside the tube as one cuff of the radius at which its polygon has the same length.
TEST_F(Cad, a_closed_tube_of_triangles_is_meshed_anew_without_a_fold) {
  constexpr double radius = 30, length = 100;
  constexpr int around = 48;
  write_stl_tube(radius, length, around, 12, at("tube.stl"));
  Case data;
  data.name = "tube";
  data.materials["steel"] = {200e9, 0.3, 7800};
  data.mount = {{.cap = "left"}};
  data.analyses.modes = Modes{.count = 4};
  MeridianSection cuff;
  cuff.shape = SectionShape::cuff;
  cuff.length = 1e-3 * length;
  Bellows bellows;
  bellows.material = "steel";
  bellows.root_radius = 1e-3 * radius;
  bellows.profile = {cuff};
  bellows.wall.plies = {1.5e-3};
  bellows.mesh.accuracy = 0.01;
  data.parts = {{"tube", bellows}};
  data.caps = {{.name = "left", .of = {"tube.left"}},
               {.name = "right", .of = {"tube.right"}, .mass = 0.2}};
  const Results own = run_silently(data);
  for (const double size : {12e-3, 8e-3, 5e-3}) {
    const SurfacePart surface{.material = "steel",
                              .file = at("tube.stl").string(),
                              .unit = 1e-3,
                              .thickness = 1.5e-3,
                              .size = size};
    EXPECT_GT(mesh_quality(surface_mesh(surface)).min_jacobian, 0.01) << size;
    data.parts = {{"tube", surface}};
    data.caps[0].of = {"tube.edge[1]"};
    data.caps[1].of = {"tube.edge[2]"};
    const Results read = run_silently(data);
    compare("tube", "clamped bending mode, elements of " + std::to_string(size),
            read.modes[0].frequency, own.modes[0].frequency, 0.03);
  }
}

TEST_F(Cad, surfaces_come_back_as_they_were_written) {
  Surface s;
  s.nodes = {{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.2, 0}, {0, 0.2, 0.03}};
  s.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (const char* name : {"a.obj", "a.ply", "a.stl", "a.glb"}) {
    write_surface(s, {}, at(name));
    const Surface read = read_surface(at(name), 1, 1e-6);
    ASSERT_EQ(read.nodes.size(), 4u) << name;
    ASSERT_EQ(read.triangles.size(), 2u) << name;
    for (std::size_t t = 0; t < 2; ++t)
      for (std::size_t c = 0; c < 3; ++c) {
        const Vector3d was = s.nodes[std::size_t(s.triangles[t][c])];
        double nearest = 1;
        for (int node : read.triangles[t])
          nearest = std::min(nearest, (read.nodes[std::size_t(node)] - was).norm());
        EXPECT_LT(nearest, 1e-7) << name; // single precision
      }
    EXPECT_LT((read_surface(at(name), 1e-3, 1e-9).nodes[2] - read.nodes[2] / 1e3).norm(), 1e-12)
        << name;
  }
}

TEST_F(Cad, broken_files_are_refused_with_what_is_wrong) {
  write("no.step", "ISO-10303-21;\nHEADER;\nthis is not one\n");
  EXPECT_NE(refusal("file: no.step, element_size: 5 mm").find("no.step"), std::string::npos);
  EXPECT_NE(refusal("file: gone.step, element_size: 5 mm").find("there is no file"),
            std::string::npos);
  write_stl_plate(30, 20, 2, at("plate.stl"));
  EXPECT_NE(
      refusal("file: plate.stl, element_size: 5 mm").find("does not say what its numbers mean"),
      std::string::npos);
  EXPECT_EQ(refusal("file: plate.stl, unit: 1 mm, element_size: 5 mm"), "no error");
  std::ifstream in(at("plate.stl"));
  const std::string whole{std::istreambuf_iterator<char>(in), {}};
  write("cut.stl", whole.substr(0, whole.size() / 2));
  EXPECT_NE(refusal("file: cut.stl, unit: 1 mm, element_size: 5 mm").find("cut short"),
            std::string::npos);
  std::string bad = whole;
  bad.replace(bad.find("vertex 15"), 9, "vertex nan");
  write("nan.stl", bad);
  EXPECT_NE(refusal("file: nan.stl, unit: 1 mm, element_size: 5 mm"), "no error");
  write("empty.stl", "solid nothing\nendsolid nothing\n");
  EXPECT_NE(refusal("file: empty.stl, unit: 1 mm, element_size: 5 mm"), "no error");
  std::string binary(84, '\0');
  binary[80] = 100; // facets that are not there
  write("short.stl", binary);
  EXPECT_NE(refusal("file: short.stl, unit: 1 mm, element_size: 5 mm"), "no error");
  write("a.txt", "x");
  EXPECT_NE(refusal("file: a.txt, element_size: 5 mm").find("neither CAD faces nor triangles"),
            std::string::npos);
  in_gmsh([&] {
    write_in_millimetres();
    gmsh::model::occ::addBox(0, 0, 0, 10, 10, 10);
    gmsh::model::occ::synchronize();
    gmsh::write(at("box.step").string());
  });
  EXPECT_NE(refusal("file: box.step, element_size: 5 mm").find("solids"), std::string::npos);
  write_bracket_on_pipe({}, at("pipe.step"));
  EXPECT_NE(refusal("file: pipe.step, element_size: 5 um").find("elements: is the element size"),
            std::string::npos);
}

TEST(ShellSurface, refuses_a_band_with_one_side) {
  SurfaceFaces band;
  constexpr int n = 12;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n, half = a / 2;
    for (double w : {-0.02, 0.02})
      band.nodes.emplace_back((0.1 + w * std::cos(half)) * std::cos(a),
                              (0.1 + w * std::cos(half)) * std::sin(a), w * std::sin(half));
  }
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i, b = 2 * ((i + 1) % n);
    if (i + 1 < n)
      band.faces.push_back({a, a + 1, b + 1, b});
    else
      band.faces.push_back({a, a + 1, b, b + 1});
  }
  EXPECT_THROW(shell_mesh(band, 1e-3, WallSide::middle), std::runtime_error);
}

} // namespace
} // namespace plica::test

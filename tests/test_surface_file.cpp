#include "mesh/generation/surface_file.hpp"
#include "mesher/surface_frame.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>
#include <fstream>

namespace {

using namespace plica;
using Eigen::MatrixXd;
using Eigen::Vector3d;

Surface roof() {
  Surface s;
  s.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}, {0, 2, 1}};
  s.triangles = {{0, 1, 2}, {0, 2, 3}};
  s.lines = {{3, 4}};
  return s;
}

SurfaceShape shape(double size) {
  MatrixXd u(5, 3);
  for (int i = 0; i < 5; ++i) u.row(i) << 0.1 * size * i, -0.2 * size, size;
  return {"mode", u};
}

// The two chunks of a glTF in one file: Khronos Group, glTF 2.0 specification, section 4.4.
struct Glb {
  nlohmann::json json;
  std::string bytes;
};
Glb parsed(const std::string& text) {
  const auto word = [&](std::size_t at) {
    std::uint32_t w = 0;
    std::memcpy(&w, text.data() + at, 4);
    return w;
  };
  EXPECT_EQ(text.substr(0, 4), "glTF");
  EXPECT_EQ(word(4), 2u);
  EXPECT_EQ(word(8), text.size());
  const std::uint32_t size = word(12);
  return {nlohmann::json::parse(text.substr(20, size)), text.substr(28 + size)};
}

std::vector<Vector3d> vectors(const Glb& g, int accessor) {
  const auto& a = g.json["accessors"][accessor];
  const auto& view = g.json["bufferViews"][a["bufferView"].get<int>()];
  std::vector<Vector3d> list;
  for (int i = 0; i < a["count"].get<int>(); ++i) {
    std::array<float, 3> x{};
    std::memcpy(x.data(), g.bytes.data() + view.value("byteOffset", 0) + 12 * i, 12);
    list.emplace_back(x[0], x[1], x[2]);
  }
  return list;
}

TEST(SurfaceFile, a_mode_is_a_morph_target_of_gltf) {
  const Surface s = roof();
  const Glb g = parsed(glb_of(s, {shape(1), shape(-2)}));
  const auto& triangles = g.json["meshes"][0]["primitives"][0];
  EXPECT_EQ(triangles["mode"], 4);
  ASSERT_EQ(triangles["targets"].size(), 2u);
  const auto nodes = vectors(g, triangles["attributes"]["POSITION"]);
  const auto moved = vectors(g, triangles["targets"][1]["POSITION"]);
  ASSERT_EQ(nodes.size(), moved.size());
  ASSERT_GE(nodes.size(), 4u);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    EXPECT_LT((nodes[i] - s.nodes[i]).norm(), 1e-6);
    const Vector3d u = shape(-2).displacement.row(Eigen::Index(i));
    EXPECT_LT((moved[i] - u).norm(), 1e-6);
  }
  const auto& lines = g.json["meshes"][0]["primitives"][1];
  EXPECT_EQ(lines["mode"], 1);
  EXPECT_EQ(lines["targets"].size(), 2u);
}

// glTF has y up, the part z.
TEST(SurfaceFile, gltf_stands_upright) {
  const Glb g = parsed(glb_of(roof(), {}));
  const auto m = g.json["nodes"][0]["matrix"].get<std::vector<double>>(); // by columns
  ASSERT_EQ(m.size(), 16u);
  const Vector3d up(m[8], m[9], m[10]), along(m[4], m[5], m[6]), across(m[0], m[1], m[2]);
  EXPECT_EQ(up, Vector3d(0, 1, 0));
  EXPECT_EQ(along, Vector3d(0, 0, -1));
  EXPECT_EQ(across, Vector3d(1, 0, 0));
}

TEST(SurfaceFile, refuses_what_it_does_not_write) {
  const test::TemporaryFolder folder("surface");
  EXPECT_THROW(write_surface(roof(), {}, folder.path / "a.vrml"), std::invalid_argument);
  EXPECT_THROW(write_surface(roof(), {}, folder.path / "no such folder" / "a.obj"),
               std::runtime_error);
  SurfaceShape bad = shape(1);
  bad.displacement.conservativeResize(3, 3);
  EXPECT_THROW(glb_of(roof(), {bad}), std::invalid_argument);
}

TEST(SurfaceFile, moves_by_a_shape) {
  const Surface moved = deformed(roof(), shape(0.5));
  EXPECT_LT((moved.nodes[4] - Vector3d(0.2, 1.9, 1.5)).norm(), 1e-15);
  EXPECT_EQ(moved.triangles, roof().triangles);
}

// What assimp passes over is refused before it reads: lines left out or doubled, counts that are
// not kept, vertices that are not there.
TEST(SurfaceFrame, of_damaged_triangles_is_refused) {
  const auto refusal = [](const std::string& suffix, const std::string& bytes) {
    try {
      check_surface_bytes(suffix, bytes);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto without = [](std::string text, const std::string& part) {
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.erase(at, part.size());
  };
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                            "vertex 1 1 0\nendloop\nendfacet\n";
  const std::string stl = "solid a b\n" + facet + facet + "endsolid a b\n";
  EXPECT_EQ(refusal(".stl", stl), "");
  EXPECT_EQ(refusal(".stl", without(stl, "vertex 1 0 0\n")),
            "line 6: 'endloop' where vertex is due");
  EXPECT_EQ(refusal(".stl", without(stl, "endfacet\n")), "line 8: 'facet' where endfacet is due");
  EXPECT_NE(refusal(".stl", without(stl, "endsolid a b\n")), "");
  EXPECT_NE(refusal(".stl", stl + std::string(60, 'x')), "");
  EXPECT_NE(refusal(".stl", without(stl, "vertex 1 0 0\n").insert(30, 1, '\0')), "");
  std::string binary(84, ' ');
  binary.replace(80, 4, std::string("\2\0\0\0", 4));
  EXPECT_EQ(refusal(".stl", binary + std::string(100, '\0')), "");
  EXPECT_NE(refusal(".stl", binary + std::string(99, '\0')).find("184"), std::string::npos);
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty "
                          "float y\nproperty float z\nelement face 1\nproperty list uchar int "
                          "vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_EQ(refusal(".ply", ply), "");
  EXPECT_NE(refusal(".ply", without(ply, "1 0 0\n")), "");
  EXPECT_NE(refusal(".ply", ply + "3 0 1 2\n"), "");
  EXPECT_EQ(refusal(".ply", without(ply, "3 0 1 2\n") + "3 0 1 3\n"),
            "line 13: a face names vertex 3 of 3");
  const std::string obj =
      "# a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\nf -3 -2 -1\n";
  EXPECT_EQ(refusal(".obj", obj), "");
  EXPECT_EQ(refusal(".obj", without(obj, "v 1 0 0\n")), "line 5: a face names vertex 3 of 2");
  EXPECT_EQ(refusal(".obj", obj + "w 1 2 3\n"), "line 8: 'w' begins no line of an OBJ of faces");
  EXPECT_EQ(refusal(".obj", obj + "v 1 nan 3\n"), "line 8: 'nan' is no finite number");
  const std::string glb = glb_of(roof(), {});
  EXPECT_EQ(refusal(".glb", glb), "");
  EXPECT_NE(refusal(".glb", glb.substr(0, glb.size() - 4)), "");
}

} // namespace

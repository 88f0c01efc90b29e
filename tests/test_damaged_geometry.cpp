// Damaged files of geometry: an error with the file and what is wrong, or what the whole file
// gives; never a crash, never without end.
#include "tests/cad_samples.hpp"
#include "tests/geometry_folder.hpp"

#include "mesh/generation/surface_file.hpp"
#include "mesher/brep_text.hpp"
#include "mesher/iges_text.hpp"
#include "mesher/step_text.hpp"

#include <Eigen/Geometry>

namespace plica::test {
namespace {

namespace fs = std::filesystem;

double area(const SurfaceFaces& surface) {
  double sum = 0;
  const auto x = [&](int i) { return surface.nodes[std::size_t(i)]; };
  for (const auto& [a, b, c, d] : surface.faces) {
    sum += (x(b) - x(a)).cross(x(c) - x(a)).norm() / 2;
    if (d >= 0) sum += (x(c) - x(a)).cross(x(d) - x(a)).norm() / 2;
  }
  return sum;
}

class DamagedGeometry : public GeometryFolder {
protected:
  // Each line left out in turn: refused, or the area and extent of the whole file. Gives back how
  // many were refused.
  int without_each_line(const std::string& name, const SurfaceMeshing& meshing,
                        void (*check)(const std::string&)) const;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size() - 1) + 1;
    lines.push_back(text.substr(from, end - from));
    from = end;
  }
  return lines;
}

std::string with_blank_comments(const std::string& text) {
  std::string rest;
  for (const std::string& line : lines_of(text))
    rest += line.starts_with('#') ? std::string(line.size() - 1, '#') + '\n' : line;
  return rest;
}

bool refuses(void (*check)(const std::string&), const std::string& text) {
  try {
    check(text);
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("line "), std::string::npos) << error.what();
    return true;
  }
  return false;
}

int DamagedGeometry::without_each_line(const std::string& name, const SurfaceMeshing& meshing,
                                       void (*check)(const std::string&)) const {
  const SurfaceFaces whole = mesh_surface_file(at(name), meshing);
  const std::vector<std::string> lines = lines_of(text_of(name));
  const std::string cut = "cut" + fs::path(name).extension().string();
  int refused = 0;
  for (std::size_t left_out = 0; left_out < lines.size(); ++left_out) {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (i != left_out) text += lines[i];
    if (refuses(check, text)) { // as the mesher does first
      ++refused;
      continue;
    }
    write(cut, text);
    try {
      const SurfaceFaces read = mesh_surface_file(at(cut), meshing);
      EXPECT_NEAR(area(read), area(whole), 1e-9 * area(whole)) << lines[left_out];
      EXPECT_EQ(read.nodes.size(), whole.nodes.size()) << lines[left_out];
      for (std::size_t i = 0; i < std::min(read.nodes.size(), whole.nodes.size()); ++i)
        EXPECT_LT((read.nodes[i] - whole.nodes[i]).norm(), 1e-9) << lines[left_out];
    } catch (const std::runtime_error&) {
      ++refused;
    }
  }
  return refused;
}

TEST_F(DamagedGeometry, step_without_any_one_line_is_refused_or_has_the_same_area) {
  write_bracket_on_pipe({}, at("pipe.step"));
  const int lines = int(lines_of(text_of("pipe.step")).size());
  const int refused = without_each_line("pipe.step", {.size = 20e-3}, check_step_text);
  // Left over: the description, and the categories of the three products.
  EXPECT_EQ(lines - refused, 4);
}

TEST_F(DamagedGeometry, brep_without_any_one_line_is_refused_or_has_the_same_area) {
  Meridian tube(0, 0.03);
  tube.add_cuff(0.2, 0.03, 1);
  write_revolved(tube, at("tube.brep"));
  const std::vector<std::string> lines = lines_of(text_of("tube.brep"));
  const int refused =
      without_each_line("tube.brep", {.unit = 1e-3, .size = 20e-3}, check_brep_text);
  const auto empty = std::count(lines.begin(), lines.end(), "\n");
  EXPECT_GE(refused, int(lines.size()) - int(empty) - 1); // the name of the writer
}

TEST_F(DamagedGeometry, iges_without_any_one_line_is_refused) {
  write_iges_tube(30, 200, at("tube.igs"));
  const int lines = int(lines_of(text_of("tube.igs")).size());
  EXPECT_EQ(without_each_line("tube.igs", {.size = 20e-3}, check_iges_text), lines);
}

// What OpenCASCADE takes for zero, or never ends with.
TEST_F(DamagedGeometry, brep_and_iges_whose_numbers_are_none_are_refused_with_the_line) {
  Meridian tube(0, 0.03);
  tube.add_cuff(0.2, 0.03, 1);
  write_revolved(tube, at("tube.brep"));
  write_iges_tube(30, 200, at("tube.igs"));
  const std::string brep = text_of("tube.brep"), iges = text_of("tube.igs");
  const auto refused = [](auto check, std::string text, const std::string& from,
                          const std::string& to, const std::string& says) {
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    text.replace(std::min(place, text.size()), from.size(), to);
    try {
      check(text);
      ADD_FAILURE() << to;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
      EXPECT_TRUE(std::string(error.what()).starts_with("line ")) << error.what();
    }
  };
  EXPECT_NO_THROW(check_brep_text(brep));
  EXPECT_NO_THROW(check_iges_text(iges));
  refused(check_iges_text, iges, "8Htube.igs,5HPli",
          std::string("8Htube.igs,5") + std::string(4, '\0'), "control character");
  refused(check_brep_text, brep, "-1 30\n", "-1 3O\n", "'3O' where a number belongs");
  refused(check_brep_text, brep, "-1 30\n", "-1 nan\n", "'nan' where a number belongs");
  refused(check_brep_text, brep, "-1 30\n", "-1 1E30\n", "'1E30' where a number belongs");
  refused(check_brep_text, brep, "Curves 3", "Curves 2", "where Polygon3D begin");
  refused(check_brep_text, brep, "1  3 0 0 200", "1  9 0 0 200", "number 9 of 3 Curves");
  refused(check_brep_text, brep, "+7 0 -5 0", "-5 0", "part of no other");
  refused(check_iges_text, iges, ",2,2HMM", ",1,2HMM", "do not go together");
  refused(check_iges_text, iges, "P      3", "P      4", "P4 where P3 belongs");
  refused(check_iges_text, iges, "D      6P", "D      8P", "the file has 6 lines D");
  refused(check_iges_text, iges, "6.283185307179586;", "6.283185307179586,", "does not end");
  refused(check_iges_text, iges, "120,1,3,", "110,1,3,", "the directory says 120");
}

TEST_F(DamagedGeometry, step_with_numbers_that_do_not_agree_is_refused) {
  write_bracket_on_pipe({}, at("pipe.step"));
  const std::string whole = text_of("pipe.step");
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    write("changed.step", text);
    return refusal("changed.step", {.size = 20e-3});
  };
  EXPECT_EQ(changed("CYLINDRICAL_SURFACE", "CYLINDRICAL_SURFACE"), "");
  for (const auto& [from, to, says] :
       {std::array{"'',#48,65.", "'',#48,35.", "lies off"},
        {"CYLINDRICAL_SURFACE('',#54,65.", "CYLINDRICAL_SURFACE('',#54,64.", "lies off"},
        {"(0.,120.,105.)", "(0.,120.,505.)", "lies off"},
        {"#193 = VECTOR", "#2147483648 = VECTOR", "#2147483648 is above 2147483647"},
        {"#193 = VECTOR", "#192 = VECTOR", "#192 is defined a second time"},
        {"(#127,#150,#166,#182)", "(#127,#150,#166,#9999)",
         "#9999 is named here and defined nowhere"},
        {"(#127,#150,#166,#182)", "(#127,#150,#166)", "ORIENTED_EDGE #182 belongs to nothing"},
        {"(#125,#196),#139", "(#125),#139", "FACE_BOUND #196 belongs to nothing"},
        {"PLANE('',#140)", "PLANE('',#141)", "OpenCASCADE says"},
        {"((#104,#105,#106))", "((#105,#106))", "no unit of length"},
        {"(0.,120.,105.)", "(0.,12O.,105.)", "is missing before"}}) {
    const std::string said = changed(from, to);
    EXPECT_NE(said.find(says), std::string::npos) << to << ": " << said;
    EXPECT_TRUE(said.starts_with("changed.step: ")) << said;
  }
}

// A tube of triangles in four formats: each byte of its text or count in turn would be too many, so
// what is known to be silent in assimp.
TEST_F(DamagedGeometry, triangles_whose_file_is_not_whole_are_refused) {
  write_stl_tube(30, 100, 24, 6, at("tube.stl"));
  const Surface tube = read_surface(at("tube.stl"), 1e-3, 1e-6);
  for (const char* name : {"tube.obj", "tube.ply", "tube.glb", "binary.stl"})
    write_surface(tube, {}, at(name));
  write("tube.obj", with_blank_comments(text_of("tube.obj")));
  const SurfaceMeshing as_they_are{.unit = 1};
  for (const char* name : {"tube.stl", "tube.obj", "tube.ply", "tube.glb", "binary.stl"}) {
    EXPECT_EQ(refusal(name, as_they_are), "") << name;
    const std::string whole = text_of(name);
    const std::string cut = "cut" + fs::path(name).extension().string();
    std::string part = whole.substr(0, 3 * whole.size() / 5);
    if (cut == "cut.obj") part.resize(part.rfind('\n') + 1);
    write(cut, part);
    const std::string said = refusal(cut, as_they_are);
    EXPECT_TRUE(said.starts_with(cut + ": ")) << name << said;
    EXPECT_EQ(said.find("broke down"), std::string::npos) << name << said;
  }
  const auto changed = [&](const std::string& name, const std::string& from,
                           const std::string& to) {
    std::string text = text_of(name);
    const std::size_t place = text.find(from, 3 * text.size() / 5);
    EXPECT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    const std::string damaged = "damaged" + fs::path(name).extension().string();
    write(damaged, text);
    return refusal(damaged, as_they_are);
  };
  EXPECT_NE(changed("tube.stl", "vertex ", "vertex x").find("is no finite number"),
            std::string::npos);
  EXPECT_NE(changed("tube.stl", "endloop\n", "").find("where endloop is due"), std::string::npos);
  EXPECT_NE(changed("tube.obj", "\nf ", "\n# ").find("a triangle is missing"), std::string::npos);
  EXPECT_NE(changed("tube.obj", "\nf ", "\ng ").find("two lines ran together"), std::string::npos);
  EXPECT_NE(changed("tube.obj", "\nf ", "\nf 9999 ").find("names vertex 9999 of"),
            std::string::npos);
  EXPECT_NE(changed("tube.obj", "\nf ", "\nx ").find("begins no line of an OBJ"),
            std::string::npos);
  // A facet of the STL with one corner elsewhere, and one so far away that nobody meant it.
  EXPECT_NE(
      changed("tube.stl", "vertex 30 50 0", "vertex 36 50 0").find("away from its neighbours"),
      std::string::npos);
  EXPECT_NE(changed("tube.stl", "vertex 30 50 0", "vertex 3e9 50 0").find("is its unit right"),
            std::string::npos);
}

// The comments of some writers count, and an OBJ has no other count: of a triangle gone from a rim
// nothing else tells, and of two lines that ran together the corners in a name.
TEST_F(DamagedGeometry, an_obj_with_other_counts_than_its_comments_say_is_refused) {
  write_stl_tube(30, 100, 24, 6, at("tube.stl"));
  write_surface(read_surface(at("tube.stl"), 1e-3, 1e-6), {}, at("tube.obj"));
  const std::string whole = text_of("tube.obj");
  // From the first `from` up to the next `to`.
  const auto said_without = [&](const std::string& text, const std::string& from,
                                const std::string& to) {
    const std::size_t begin = text.find(from), end = text.find(to, begin + 1);
    EXPECT_NE(end, std::string::npos) << from << to;
    write("less.obj", text.substr(0, begin) + text.substr(end));
    return refusal("less.obj", {.unit = 1});
  };
  const std::string face = said_without(whole, "f ", "f ");
  EXPECT_NE(face.find("counts 288 faces, and there are 287"), std::string::npos) << face;
  EXPECT_TRUE(face.starts_with("less.obj: line ")) << face;
  const std::string bare = with_blank_comments(whole);
  EXPECT_EQ(said_without(bare, "f ", "f "), "");
  const std::string together = said_without(bare, "surface", "//");
  EXPECT_NE(together.find("is a corner of a face in a line of g"), std::string::npos) << together;
}

// Two lines of triangles that ran together: one corner of their polygon is far off the plane of the
// others. A quad whose halves fold by 20 degrees is one.
TEST_F(DamagedGeometry, a_polygon_across_the_part_is_refused) {
  const auto quad = [&](double fold) {
    const double up = std::tan(fold * std::numbers::pi / 180) / std::sqrt(2);
    write("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 " + std::to_string(up) + "\nv 0 1 0\nf 1 2 3 4\n");
    return refusal("quad.obj", {});
  };
  EXPECT_EQ(quad(0), "");
  EXPECT_EQ(quad(20), "");
  for (const double fold : {45., 80.}) {
    const std::string said = quad(fold);
    EXPECT_NE(said.find("the polygon of 4 corners, one at [0, 0, 0]"), std::string::npos) << said;
    EXPECT_NE(said.find("is not flat"), std::string::npos) << said;
  }
}

// Four triangles on one another: meshed anew they never end.
TEST_F(DamagedGeometry, triangles_on_each_other_are_refused) {
  write("twice.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2 3\nf 1 3 4\n");
  write("folded.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\nf 1 2 4\nf 2 3 4\n");
  for (const double size : {0., 0.05}) {
    EXPECT_NE(refusal("twice.obj", {.size = size}).find("the same three vertices"),
              std::string::npos);
    EXPECT_NE(refusal("folded.obj", {.size = size}).find("lie on each other"), std::string::npos);
  }
}

// A ring of 64 corners and elements far larger than it: 6 % of its area were gone.
TEST_F(DamagedGeometry, a_mesh_of_another_area_than_its_triangles_is_refused_naming_both) {
  std::ofstream out(at("ring.obj"));
  constexpr int n = 32;
  for (double r : {0.74, 0.69})
    for (int i = 0; i < n; ++i)
      out << "v 0 " << r * std::cos(2 * std::numbers::pi * i / n) << ' '
          << r * std::sin(2 * std::numbers::pi * i / n) << '\n';
  for (int i = 0; i < n; ++i) {
    const int a = i + 1, b = (i + 1) % n + 1;
    out << "f " << a << ' ' << b << ' ' << b + n << ' ' << a + n << '\n';
  }
  out.close();
  const double exact = n / 2. * std::sin(2 * std::numbers::pi / n) * (0.74 * 0.74 - 0.69 * 0.69);
  EXPECT_NEAR(exact, 0.22318, 1e-5);
  EXPECT_NEAR(area(mesh_surface_file(at("ring.obj"), {.size = 30e-3})), exact, 0.01 * exact);
  const std::string said = refusal("ring.obj", {.size = 0.5});
  EXPECT_NE(said.find(" mm2 of triangles of 22318"), std::string::npos) << said;
  EXPECT_NE(said.find("Gmsh made a mesh of "), std::string::npos) << said;
}

} // namespace
} // namespace plica::test

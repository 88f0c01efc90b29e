#include "mesher/surface_frame.hpp"

#include "mesher/surface_words.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace plica {
namespace {

// Words that may begin a line, beside v and f; what they say is no triangle.
constexpr std::array other_words{"vt",       "vn",       "vp",         "l",        "p",
                                 "g",        "o",        "s",          "mg",       "usemtl",
                                 "mtllib",   "usemap",   "maplib",     "bevel",    "lod",
                                 "c_interp", "d_interp", "shadow_obj", "trace_obj"};

// One corner: 3, 3/1, 3//2, 3/1/2; negative ones count from the last vertex.
void check_corner(const TextLine& line, std::string_view corner, long vertices) {
  const long n = whole_number(line, corner.substr(0, corner.find('/')));
  if (n == 0 || std::labs(n) > vertices)
    surface_error(line.number,
                  "a face names vertex " + std::to_string(n) + " of " + std::to_string(vertices));
  for (std::size_t at = corner.find('/'); at != std::string_view::npos;) {
    const std::size_t next = corner.find('/', at + 1);
    const std::string_view part = corner.substr(at + 1, next - at - 1);
    if (!part.empty()) whole_number(line, part);
    at = next;
  }
}

} // namespace

void check_obj(const std::string& bytes) {
  const std::vector<TextLine> lines = lines_of_words(bytes);
  const long vertices = std::count_if(lines.begin(), lines.end(), [](const TextLine& line) {
    return !line.words.empty() && line.words[0] == "v";
  });
  bool goes_on = false;
  for (const TextLine& line : lines) {
    if (line.words.empty() || line.words[0].starts_with('#')) continue;
    const std::string_view first = line.words[0];
    const bool continued = line.words.back().ends_with('\\');
    if (goes_on || continued) {
      goes_on = continued; // a line in two: left to assimp
    } else if (first == "v") {
      for (std::size_t i = 1; i < std::max<std::size_t>(4, line.words.size()); ++i)
        finite_number(line, i);
    } else if (first == "f") {
      if (line.words.size() < 4) surface_error(line.number, "a face of fewer than three vertices");
      for (std::size_t i = 1; i < line.words.size(); ++i)
        check_corner(line, line.words[i], vertices);
    } else if (std::find(other_words.begin(), other_words.end(), first) == other_words.end()) {
      surface_error(line.number, shown_word(first) + " begins no line of an OBJ of faces");
    }
  }
}

void check_surface_bytes(const std::string& suffix, const std::string& bytes) {
  if (suffix == ".stl") check_stl(bytes);
  if (suffix == ".ply") check_ply(bytes);
  if (suffix == ".obj") check_obj(bytes);
  if (suffix == ".glb") check_glb(bytes);
  if (suffix == ".gltf") check_gltf(bytes);
}

} // namespace plica

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

// One corner: 3, 3/1, 3//2, 3/1/2; negative ones count from the last vertex. Gives back the vertex,
// from 1; `before` is the last one so far.
long check_corner(const TextLine& line, std::string_view corner, long vertices, long before) {
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
  return std::clamp(n > 0 ? n : before + 1 + n, 1L, vertices);
}

// A file that ends early at the end of a line is a whole one otherwise.
void require_used(const std::vector<int>& lines, const std::vector<char>& used) {
  for (std::size_t v = 0; v < lines.size(); ++v)
    if (used[v + 1] == 0)
      surface_error(lines[v], "no face uses this vertex: what did may be missing");
}

} // namespace

void check_obj(const std::string& bytes) {
  const std::vector<TextLine> lines = lines_of_words(bytes);
  const long vertices = std::count_if(lines.begin(), lines.end(), [](const TextLine& line) {
    return !line.words.empty() && line.words[0] == "v";
  });
  std::vector<int> defined; // the lines of vertices
  std::vector<char> used(std::size_t(vertices) + 1, 0);
  bool goes_on = false, whole_lines = true;
  for (const TextLine& line : lines) {
    if (line.words.empty() || line.words[0].starts_with('#')) continue;
    const std::string_view first = line.words[0];
    const bool continued = line.words.back().ends_with('\\');
    if (goes_on || continued) {
      goes_on = continued; // a line in two: left to assimp
      whole_lines = false;
    } else if (first == "v") {
      for (std::size_t i = 1; i < std::max<std::size_t>(4, line.words.size()); ++i)
        finite_number(line, i);
      defined.push_back(line.number);
    } else if (first == "f") {
      if (line.words.size() < 4) surface_error(line.number, "a face of fewer than three vertices");
      for (std::size_t i = 1; i < line.words.size(); ++i)
        used[std::size_t(check_corner(line, line.words[i], vertices, long(defined.size())))] = 1;
    } else if (first == "l" || first == "p") {
      for (std::size_t i = 1; i < line.words.size(); ++i)
        used[std::size_t(check_corner(line, line.words[i], vertices, long(defined.size())))] = 1;
    } else if (std::find(other_words.begin(), other_words.end(), first) == other_words.end()) {
      surface_error(line.number, shown_word(first) + " begins no line of an OBJ of faces");
    }
  }
  if (whole_lines) require_used(defined, used);
}

void check_surface_bytes(const std::string& suffix, const std::string& bytes) {
  if (suffix == ".stl") check_stl(bytes);
  if (suffix == ".ply") check_ply(bytes);
  if (suffix == ".obj") check_obj(bytes);
  if (suffix == ".glb") check_glb(bytes);
  if (suffix == ".gltf") check_gltf(bytes);
}

} // namespace plica

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

// Two lines that ran together: "g pipe 2//2 3//2".
bool holds_corner(std::string_view word) {
  const auto digit = [&](std::size_t at) {
    return at < word.size() && word[at] >= '0' && word[at] <= '9';
  };
  const std::size_t at = word.find("//");
  return at != std::string_view::npos && at > 0 && digit(at - 1) && digit(at + 2);
}

class ObjText {
public:
  explicit ObjText(const std::string& text) : lines_(lines_of_words(text)) {
    vertices_ = std::count_if(lines_.begin(), lines_.end(), [](const TextLine& line) {
      return !line.words.empty() && line.words[0] == "v";
    });
    used_.assign(std::size_t(vertices_) + 1, 0);
  }

  void check() {
    bool goes_on = false, whole_lines = true;
    for (const TextLine& line : lines_) {
      if (line.words.empty()) continue;
      const bool continued = line.words.back().ends_with('\\');
      if (goes_on || continued) {
        goes_on = continued; // a line in two: left to assimp
        whole_lines = false;
      } else if (line.words[0].starts_with('#')) {
        comment(line);
      } else {
        entry(line, line.words[0]);
      }
    }
    if (!whole_lines) return;
    require_counted();
    require_used();
  }

private:
  // As assimp counts, and so what Plica writes: "# 24 vertex positions", "# Mesh 'pipe' with 32
  // faces", lines and points among them.
  struct Counted {
    long number = -1;
    int line = 0;
  };

  void comment(const TextLine& line) {
    const std::vector<std::string_view>& words = line.words;
    const std::size_t n = words.size();
    const auto count = [&](Counted& of, std::string_view word) {
      if (word.find_first_not_of("0123456789") != std::string_view::npos) return;
      of = {std::max(of.number, 0L) + whole_number(line, word), line.number};
    };
    if (n == 4 && words[2] == "vertex" && words[3] == "positions")
      count(counted_vertices_, words[1]);
    if (n > 3 && words[1] == "Mesh" && words[n - 3] == "with" && words[n - 1] == "faces")
      count(counted_faces_, words[n - 2]);
  }

  void entry(const TextLine& line, std::string_view first) {
    if (first == "v") {
      for (std::size_t i = 1; i < std::max<std::size_t>(4, line.words.size()); ++i)
        finite_number(line, i);
      defined_.push_back(line.number);
    } else if (first == "f") {
      if (line.words.size() < 4) surface_error(line.number, "a face of fewer than three vertices");
      ++faces_;
      corners(line);
    } else if (first == "l" || first == "p") {
      ++faces_;
      corners(line);
    } else if (std::find(other_words.begin(), other_words.end(), first) == other_words.end()) {
      surface_error(line.number, shown_word(first) + " begins no line of an OBJ of faces");
    } else if (const auto corner = std::find_if(line.words.begin(), line.words.end(), holds_corner);
               corner != line.words.end()) {
      surface_error(line.number, shown_word(*corner) + " is a corner of a face in a line of " +
                                     std::string(first) + ": two lines ran together");
    }
  }

  void corners(const TextLine& line) {
    for (std::size_t i = 1; i < line.words.size(); ++i)
      used_[std::size_t(check_corner(line, line.words[i], vertices_, long(defined_.size())))] = 1;
  }

  static void require(const Counted& counted, long found, const std::string& what) {
    if (counted.number >= 0 && counted.number != found)
      surface_error(counted.line, "this comment counts " + std::to_string(counted.number) + " " +
                                      what + ", and there are " + std::to_string(found) +
                                      ": the file is damaged, or the comment is another's");
  }

  void require_counted() const {
    require(counted_vertices_, vertices_, "vertices");
    require(counted_faces_, faces_, "faces");
  }

  // A file that ends early at the end of a line is a whole one otherwise.
  void require_used() const {
    for (std::size_t v = 0; v < defined_.size(); ++v)
      if (used_[v + 1] == 0)
        surface_error(defined_[v], "no face uses this vertex: what did may be missing");
  }

  std::vector<TextLine> lines_;
  long vertices_ = 0, faces_ = 0; // of faces also lines and points
  Counted counted_vertices_, counted_faces_;
  std::vector<int> defined_; // the lines of vertices
  std::vector<char> used_;   // by the number of the vertex, from 1
};

} // namespace

void check_obj(const std::string& bytes) {
  ObjText(bytes).check();
}

} // namespace plica

#include "mesher/brep_text.hpp"

#include "mesher/step_parser.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

namespace plica {
namespace {

// Of a size that a part can have; an end at infinity is none.
bool is_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  constexpr double largest = 1e15;
  return error == std::errc{} && end == word.data() + word.size() && std::abs(value) <= largest;
}

class BrepText {
public:
  explicit BrepText(std::string_view text) : text_(text) {}

  void check() {
    head();
    section("Locations", [&] { location(); });
    section("Curve2ds", [&] { curve(2); });
    section("Curves", [&] { curve(3); });
    drawn("Polygon3D");
    drawn("PolygonOnTriangulations");
    section("Surfaces", [&] { surface(); });
    drawn("Triangulations");
    section("TShapes", [&] { shape(); });
    used_.insert(reference(next()));
    located();
    if (skip(), at_ < text_.size()) fail("something follows the shape");
    const long shapes = count_["TShapes"];
    for (long i = 1; i <= shapes; ++i)
      if (!used_.contains(i))
        fail("shape " + std::to_string(i) + " of " + std::to_string(shapes) +
             " is part of no other: what held it is missing");
  }

private:
  [[noreturn]] void fail(const std::string& what) const { step_error(line_, what); }

  void skip() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])))
      line_ += text_[at_++] == '\n';
  }
  std::string_view next() {
    skip();
    const std::size_t from = at_;
    while (at_ < text_.size() && !std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
    if (at_ == from) fail("the file ends here: it was cut short");
    return text_.substr(from, at_ - from);
  }
  void numbers(long count) {
    for (long i = 0; i < count; ++i)
      if (const std::string_view word = next(); !is_number(word))
        fail("'" + std::string(word.substr(0, 30)) + "' where a number belongs");
  }
  long whole(long least = 0) {
    const std::string_view word = next();
    long value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    constexpr long most = 100'000'000;
    if (error != std::errc{} || end != word.data() + word.size() || value < least || value > most)
      fail("'" + std::string(word.substr(0, 30)) + "' where a number from " +
           std::to_string(least) + " on belongs");
    return value;
  }

  void one_of(std::string_view section) {
    if (const long number = whole(1); number > count_[section])
      fail("number " + std::to_string(number) + " of " + std::to_string(count_[section]) + " " +
           std::string(section));
  }
  void located() {
    if (whole(0) > count_["Locations"])
      fail("a location of more than " + std::to_string(count_["Locations"]));
  }

  void head() {
    const std::size_t at = text_.find("CASCADE Topology V");
    if (at == std::string_view::npos) fail("this is no BREP file of OpenCASCADE");
    line_ += int(std::count(text_.begin(), text_.begin() + std::ptrdiff_t(at), '\n'));
    version_ = at + 18 < text_.size() ? text_[at + 18] - '0' : 0;
    at_ = std::min(text_.find('\n', at), text_.size());
  }
  template <class F> void section(std::string_view name, F&& one) {
    if (const std::string_view word = next(); word != name)
      fail("'" + std::string(word.substr(0, 30)) + "' where " + std::string(name) + " begin");
    const long count = whole();
    count_[name] = count;
    for (long i = 0; i < count; ++i) one();
  }
  // Triangles and polygons for pictures: nothing is made of them.
  void drawn(std::string_view name) {
    if (const std::string_view word = next(); word != name)
      fail("'" + std::string(word.substr(0, 30)) + "' where " + std::string(name) + " begin");
    if (whole() == 0) return;
    for (;;) {
      skip();
      if (at_ < text_.size() && (text_[at_] == 'P' || text_[at_] == 'S' || text_[at_] == 'T'))
        return;
      if (const std::string_view word = next(); word != "p" && !is_number(word))
        fail("'" + std::string(word.substr(0, 30)) + "' where a number belongs");
    }
  }
  void location() {
    constexpr long matrix = 1, product = 2;
    const long kind = whole(matrix);
    if (kind == matrix) return numbers(12);
    if (kind != product) fail("a location of an unknown kind, " + std::to_string(kind));
    while (whole() > 0) numbers(1);
  }

  void curve(long dimensions) {
    // line, circle, ellipse, parabola, hyperbola
    constexpr std::array<long, 5> plane{4, 7, 8, 7, 8}, space{6, 13, 14, 13, 14};
    const long kind = whole(1);
    if (kind <= 5) return numbers((dimensions == 2 ? plane : space)[std::size_t(kind) - 1]);
    switch (kind) {
    case 6: { // Bezier
      const long rational = whole(), degree = whole(1);
      return numbers((degree + 1) * (dimensions + (rational > 0)));
    }
    case 7: { // B-spline
      const long rational = whole();
      whole(); // periodic
      whole(1);
      const long poles = whole(2), knots = whole(2);
      return numbers(poles * (dimensions + (rational > 0)) + 2 * knots);
    }
    case 8: // trimmed
      numbers(2);
      return curve(dimensions);
    case 9: // offset
      numbers(dimensions == 2 ? 1 : 4);
      return curve(dimensions);
    default:
      fail("a curve of an unknown kind, " + std::to_string(kind));
    }
  }

  void surface() {
    constexpr std::array<long, 5> simple{12, 13, 14, 13,
                                         14}; // plane, cylinder, cone, sphere, torus
    const long kind = whole(1);
    if (kind <= 5) return numbers(simple[std::size_t(kind) - 1]);
    switch (kind) {
    case 6: // extruded
      numbers(3);
      return curve(3);
    case 7: // revolved
      numbers(6);
      return curve(3);
    case 8: { // Bezier
      const long rational = whole() + whole(), u = whole(1), v = whole(1);
      return numbers((u + 1) * (v + 1) * (3 + (rational > 0)));
    }
    case 9: { // B-spline
      const long rational = whole() + whole();
      numbers(2); // periodic
      numbers(2); // degrees
      const long u = whole(2), v = whole(2), u_knots = whole(2), v_knots = whole(2);
      return numbers(u * v * (3 + (rational > 0)) + 2 * (u_knots + v_knots));
    }
    case 10: // trimmed
      numbers(4);
      return surface();
    case 11: // offset
      numbers(1);
      return surface();
    default:
      fail("a surface of an unknown kind, " + std::to_string(kind));
    }
  }

  long reference(std::string_view word) {
    long number = 0;
    const auto [end, error] = std::from_chars(word.data() + std::min<std::size_t>(1, word.size()),
                                              word.data() + word.size(), number);
    if (word.find_first_of("+-ie") != 0 || error != std::errc{} ||
        end != word.data() + word.size() || number < 1 || number > count_["TShapes"])
      fail("'" + std::string(word.substr(0, 30)) + "' where one of " +
           std::to_string(count_["TShapes"]) + " shapes belongs");
    return number;
  }
  void vertex() {
    numbers(4); // tolerance, point
    for (;;) {  // on curves and surfaces
      numbers(1);
      const long kind = whole();
      if (kind == 0) return;
      if (kind > 3) fail("a vertex is given in an unknown way, " + std::to_string(kind));
      if (kind == 1) one_of("Curves");
      if (kind == 2) one_of("Curve2ds");
      if (kind == 3) numbers(1);
      if (kind > 1) one_of("Surfaces");
      located();
    }
  }
  // A second curve across a seam, and how smooth it is there: `4 CN` or `4CN`.
  void seam() {
    const std::string_view word = next();
    std::string_view smooth = word.substr(std::min(word.find_first_of("CG"), word.size()));
    if (!is_number(word.substr(0, word.size() - smooth.size())))
      fail("'" + std::string(word.substr(0, 30)) + "' where a curve belongs");
    if (smooth.empty()) smooth = next();
    continuity(smooth);
  }
  void continuity(std::string_view word) {
    static const std::set<std::string_view> known{"C0", "C1", "C2", "C3", "CN", "G1", "G2"};
    if (!known.contains(word))
      fail("'" + std::string(word.substr(0, 30)) + "' where a continuity (C0 to CN) belongs");
  }
  void edge() {
    numbers(4); // tolerance, three flags
    for (;;) {
      const long kind = whole();
      switch (kind) {
      case 0:
        return;
      case 1:
        one_of("Curves");
        located();
        numbers(2);
        break;
      case 2: // curve on a surface
      case 3: // on both sides of a seam
        one_of("Curve2ds");
        if (kind == 3) seam();
        one_of("Surfaces");
        located();
        numbers(2);
        if (version_ == 2) numbers(4);
        break;
      case 4: // between two surfaces
        continuity(next());
        numbers(4);
        break;
      case 5: // polygons
        numbers(2);
        break;
      case 6:
      case 7:
        numbers(kind == 6 ? 3 : 4);
        break;
      default:
        fail("an edge is given in an unknown way, " + std::to_string(kind));
      }
    }
  }
  // Its kind, its geometry, seven flags, what it is made of.
  void shape() {
    static const std::set<std::string_view> kinds{"Ve", "Ed", "Wi", "Fa", "Sh", "So", "CS", "Co"};
    const std::string_view kind = next();
    if (!kinds.contains(kind))
      fail("'" + std::string(kind.substr(0, 30)) + "' where a shape begins");
    if (kind == "Ve") vertex();
    if (kind == "Ed") edge();
    if (kind == "Fa") {
      numbers(2); // natural, tolerance
      one_of("Surfaces");
      located();
    }
    std::string_view flags = next();
    if (kind == "Fa" && flags == "2") { // its triangles
      whole(1);
      flags = next();
    }
    if (flags.size() != 7 || flags.find_first_not_of("01") != flags.npos)
      fail("'" + std::string(flags.substr(0, 30)) + "' where seven flags belong");
    for (std::string_view word = next(); word != "*"; word = next()) {
      used_.insert(reference(word));
      located();
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1, version_ = 0;
  std::map<std::string_view, long> count_; // of a section
  std::set<long> used_;
};

} // namespace

void check_brep_text(const std::string& text) {
  BrepText(text).check();
}

} // namespace plica

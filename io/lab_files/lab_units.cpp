#include "io/lab_files/lab_units.hpp"

#include "words/short_text.hpp"
#include "words/units.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <vector>

namespace plica {
namespace {

struct LabSymbol {
  std::string name;
  LabUnit unit;
};

constexpr double pound = 4.4482216152605, inch = 0.0254, gravity = 9.80665;

// What laboratories write and case files do not.
std::vector<LabSymbol> lab_symbols() {
  using namespace powers;
  constexpr double turn = 2 * std::numbers::pi;
  std::vector<LabSymbol> all;
  const auto add = [&](double factor, UnitPowers of, std::initializer_list<const char*> names) {
    for (const char* name : names) all.push_back({name, {factor, of}});
  };
  add(inch, displacement, {"in", "inch", "inches", "\""});
  add(1e-3 * inch, displacement, {"mil", "mils", "thou"});
  add(12 * inch, displacement, {"ft", "foot", "feet"});
  add(1e-6, displacement, {"micron", "microns"});
  add(1e-9, displacement, {"nm"});
  add(1, displacement, {"meter", "meters", "metre", "metres"});
  add(inch, velocity, {"ips"});
  add(gravity, acceleration, {"g", "gs", "g's", "gn", "g0", "gee"});
  add(1e-3 * gravity, acceleration, {"mg"});
  add(1e-3, force, {"mN"});
  add(1e-6, force, {"uN"});
  add(10, force, {"daN"});
  add(1, force, {"newton", "newtons"});
  add(pound, force, {"lbf", "lb", "lbs", "pound", "pounds"});
  add(1e3 * pound, force, {"kip", "klbf"});
  add(gravity, force, {"kgf", "kp"});
  add(1e-3, pressure, {"mPa"});
  add(pound / (inch * inch), pressure, {"psi"});
  add(1e5, pressure, {"bar"});
  add(1, powers::time, {"s", "sec", "secs", "second", "seconds"});
  add(1e-3, powers::time, {"ms", "msec"});
  add(1e-6, powers::time, {"us", "usec"});
  add(60, powers::time, {"min"});
  add(1, frequency, {"hertz", "cps"});
  add(1e-3, frequency, {"mHz"});
  add(1e6, frequency, {"MHz"});
  add(1. / 60, frequency, {"rpm", "cpm", "r/min", "rev/min"});
  add(1000. / 60, frequency, {"krpm"});
  add(1e-3, angle, {"mrad"});
  add(turn / 360, angle, {"degree", "degrees"});
  return all;
}

const std::vector<LabSymbol>& all_symbols() {
  static const std::vector<LabSymbol> all = [] {
    std::vector<LabSymbol> list = lab_symbols();
    const auto take = [&](Dimension dimension, UnitPowers of) {
      for (const std::string& name : units_of(dimension))
        if (std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalpha(c); }))
          list.push_back({name, {parse_quantity("1 " + name, dimension).value, of}});
    };
    take(Dimension::length, powers::displacement);
    take(Dimension::angle, powers::angle);
    take(Dimension::force, powers::force);
    take(Dimension::pressure, powers::pressure);
    take(Dimension::frequency, powers::frequency);
    list.push_back({"kg", {1, {.mass = 1}}});
    return list;
  }();
  return all;
}

std::string small(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return result;
}

// As written, or in other letters where they leave no doubt.
std::optional<LabUnit> lab_symbol(std::string_view name) {
  std::optional<LabUnit> near;
  for (const LabSymbol& s : all_symbols()) {
    if (s.name == name) return s.unit;
    if (small(s.name) != small(name)) continue;
    if (near && near->factor != s.unit.factor) return std::nullopt;
    near = s.unit;
  }
  return near;
}

// Superscripts, micro, degree, centred dot of UTF-8 and of Latin-1 as ASCII.
std::string ascii(std::string_view text) {
  struct Replacement {
    std::string_view from, to;
  };
  constexpr std::array utf8{Replacement{"\xc2\xb2", "^2"},  Replacement{"\xc2\xb3", "^3"},
                            Replacement{"\xc2\xb9", "^1"},  Replacement{"\xe2\x81\xbb", "^-"},
                            Replacement{"\xc2\xb5", "u"},   Replacement{"\xce\xbc", "u"},
                            Replacement{"\xc2\xb7", "*"},   Replacement{"\xe2\x8b\x85", "*"},
                            Replacement{"\xc2\xb0", "deg"}, Replacement{"**", "^"}};
  constexpr std::array latin1{Replacement{"\xb2", "^2"}, Replacement{"\xb3", "^3"},
                              Replacement{"\xb5", "u"}, Replacement{"\xb7", "*"},
                              Replacement{"\xb0", "deg"}};
  std::string result(text);
  const auto replace = [&](const auto& list) {
    for (const auto& [from, to] : list)
      for (auto at = result.find(from); at != std::string::npos; at = result.find(from, at))
        result.replace(at, from.size(), to);
  };
  replace(utf8);
  for (auto at = result.find("^-^"); at != std::string::npos; at = result.find("^-^"))
    result.erase(at + 2, 1); // a superscript minus before a superscript digit
  replace(latin1);
  return result;
}

LabUnit raised(const LabUnit& u, int n) {
  return {std::pow(u.factor, n),
          {n * u.powers.mass, n * u.powers.length, n * u.powers.time, n * u.powers.angle}};
}

LabUnit product(const LabUnit& a, const LabUnit& b) {
  return {a.factor * b.factor, a.powers - raised(b, -1).powers};
}

class UnitParser {
public:
  explicit UnitParser(std::string text) : text_(std::move(text)) {}

  std::optional<LabUnit> whole() {
    const auto unit = expression(0);
    skip_blanks();
    return unit && at_ == text_.size() ? unit : std::nullopt;
  }

private:
  static constexpr int deepest = 8;

  void skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  bool takes(char c) {
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  static bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) || c == '\'' || c == '"' || c == '_';
  }
  bool at_factor() const {
    return at_ < text_.size() && (is_letter(text_[at_]) || text_[at_] == '(' || text_[at_] == '1');
  }

  // Factors with * . - or a blank between them, or a / for the next one.
  std::optional<LabUnit> expression(int depth) {
    auto left = factor(depth);
    while (left) {
      skip_blanks();
      const bool over = takes('/');
      if (!over && (takes('*') || takes('.') || takes('-'))) skip_blanks();
      skip_blanks();
      if (text_.compare(at_, 4, "per ") == 0) {
        at_ += 4;
        const auto right = expression(depth + 1);
        return right ? std::optional(product(*left, raised(*right, -1))) : std::nullopt;
      }
      if (!over && !at_factor()) return left;
      const auto right = factor(depth);
      if (!right) return std::nullopt;
      left = product(*left, raised(*right, over ? -1 : 1));
    }
    return left;
  }

  std::optional<LabUnit> factor(int depth) {
    skip_blanks();
    if (depth > deepest || at_ >= text_.size()) return std::nullopt;
    std::optional<LabUnit> base;
    std::string name;
    if (takes('(')) {
      base = expression(depth + 1);
      skip_blanks();
      if (!takes(')')) return std::nullopt;
    } else if (takes('1')) {
      return LabUnit{};
    } else {
      while (at_ < text_.size() && is_letter(text_[at_])) name += text_[at_++];
      base = lab_symbol(name);
    }
    if (!base) return std::nullopt;
    const auto n = exponent();
    if (!n) return std::nullopt;
    if (small(name) == "ips" && *n == 2) return LabUnit{inch, powers::acceleration};
    return raised(*base, *n);
  }

  // Nothing for one that cannot be.
  std::optional<int> exponent() {
    const bool marked = takes('^');
    const bool bracket = marked && takes('(');
    const char* const begin = text_.data() + at_;
    const char* const end = text_.data() + text_.size();
    int n = 1;
    const bool minus_power = !marked && begin + 1 < end && *begin == '-' &&
                             std::isdigit(static_cast<unsigned char>(begin[1]));
    if (!marked && !minus_power &&
        (begin == end || !std::isdigit(static_cast<unsigned char>(*begin))))
      return 1;
    const auto [next, error] = std::from_chars(begin, end, n);
    if (error != std::errc() || std::abs(n) > 4) return std::nullopt;
    at_ += std::size_t(next - begin);
    if (bracket && !takes(')')) return std::nullopt;
    return n;
  }

  std::string text_;
  std::size_t at_ = 0;
};

} // namespace

std::optional<LabUnit> lab_unit(std::string_view text) {
  text = trimmed(text);
  constexpr std::size_t longest = 60;
  if (text.empty() || text.size() > longest) return std::nullopt;
  if (const auto known = lab_symbol(text)) return known;
  auto unit = UnitParser(ascii(text)).whole();
  if (unit && !(unit->factor > 0 && std::isfinite(unit->factor))) return std::nullopt;
  return unit;
}

bool states_no_unit(std::string_view text) {
  const std::string word = small(trimmed(text));
  constexpr std::array words{"",  "none", "(none)", "<none>",  "n/a", "na", "-", "--",
                             "?", "no",   "null",   "unknown", "eu",  "1",  "/"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::optional<double> hertz_of(const LabUnit& unit) {
  if (unit.powers == powers::frequency) return unit.factor;
  if (unit.powers == powers::turning_speed) return unit.factor / (2 * std::numbers::pi);
  return std::nullopt;
}

std::string name_of(const UnitPowers& of) {
  using namespace powers;
  struct Name {
    UnitPowers powers;
    const char* name;
  };
  constexpr std::array names{Name{none, "a ratio"},
                             Name{displacement, "a displacement"},
                             Name{velocity, "a velocity"},
                             Name{acceleration, "an acceleration"},
                             Name{force, "a force"},
                             Name{moment, "a moment"},
                             Name{pressure, "a pressure"},
                             Name{powers::time, "a time"},
                             Name{frequency, "a frequency"},
                             Name{turning_speed, "an angular velocity"},
                             Name{angle, "an angle"},
                             Name{angular_acceleration, "an angular acceleration"},
                             Name{displacement - force, "a displacement per force"},
                             Name{velocity - force, "a velocity per force"},
                             Name{acceleration - force, "an acceleration per force"}};
  const auto found =
      std::find_if(names.begin(), names.end(), [&](const Name& n) { return n.powers == of; });
  return found == names.end() ? "none of the quantities that are known" : found->name;
}

std::string known_lab_units() {
  return "known: m, mm, um, in, mil, ft; m/s2, mm/s^2, in/s^2, ips2, g; N, mN, kN, lbf, kgf; s, "
         "ms; "
         "Hz, kHz, rad/s, rpm, krpm; rad, deg; Pa; products and quotients of these";
}

} // namespace plica

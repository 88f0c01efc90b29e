#include "words/units.hpp"

#include "words/did_you_mean.hpp"

#include <charconv>
#include <cmath>
#include <numbers>

namespace plica {

namespace {

struct Unit {
  const char* name;
  double factor;
};

struct DimensionInfo {
  Dimension dimension;
  const char* name;
  std::vector<Unit> units; // SI first
};

const std::vector<DimensionInfo>& table() {
  constexpr double degree = std::numbers::pi / 180;
  static const std::vector<DimensionInfo> dimensions{
      {Dimension::number, "number", {}},
      {Dimension::ratio, "ratio", {{"%", 0.01}}},
      {Dimension::length, "length", {{"m", 1}, {"mm", 1e-3}, {"cm", 1e-2}, {"um", 1e-6}}},
      {Dimension::angle, "angle", {{"rad", 1}, {"deg", degree}}},
      {Dimension::mass, "mass", {{"kg", 1}, {"g", 1e-3}, {"t", 1e3}}},
      {Dimension::inertia, "moment of inertia", {{"kg m2", 1}, {"kg mm2", 1e-6}, {"kg cm2", 1e-4}}},
      {Dimension::density, "density", {{"kg/m3", 1}, {"g/cm3", 1e3}, {"t/mm3", 1e12}}},
      {Dimension::pressure,
       "pressure",
       {{"Pa", 1},
        {"kPa", 1e3},
        {"MPa", 1e6},
        {"GPa", 1e9},
        {"N/mm2", 1e6},
        {"bar", 1e5},
        {"mbar", 1e2}}},
      {Dimension::force, "force", {{"N", 1}, {"kN", 1e3}, {"MN", 1e6}}},
      {Dimension::moment,
       "moment",
       {{"Nm", 1}, {"N m", 1}, {"Nmm", 1e-3}, {"N mm", 1e-3}, {"kNm", 1e3}}},
      {Dimension::force_or_moment,
       "force or moment",
       {{"N", 1}, {"Nm", 1}, {"kN", 1e3}, {"MN", 1e6}, {"N m", 1}, {"Nmm", 1e-3}, {"kNm", 1e3}}},
      {Dimension::stiffness,
       "stiffness",
       {{"N/m", 1}, {"kN/m", 1e3}, {"MN/m", 1e6}, {"N/mm", 1e3}, {"kN/mm", 1e6}}},
      {Dimension::rotational_stiffness,
       "rotational stiffness",
       {{"Nm/rad", 1}, {"kNm/rad", 1e3}, {"Nm/deg", 1 / degree}}},
      {Dimension::section_stiffness,
       "section stiffness",
       {{"N m2", 1}, {"kN m2", 1e3}, {"MN m2", 1e6}, {"N mm2", 1e-6}}},
      {Dimension::mass_per_length, "mass per length", {{"kg/m", 1}, {"g/m", 1e-3}, {"g/mm", 1}}},
      {Dimension::inertia_per_length, "moment of inertia per length", {{"kg m", 1}}},
      {Dimension::damping, "damping coefficient", {{"N s/m", 1}, {"kN s/m", 1e3}, {"N s/mm", 1e3}}},
      {Dimension::rotational_damping,
       "rotational damping coefficient",
       {{"Nm s/rad", 1}, {"kNm s/rad", 1e3}}},
      {Dimension::time, "time", {{"s", 1}, {"ms", 1e-3}, {"min", 60}, {"h", 3600}}},
      {Dimension::frequency, "frequency", {{"Hz", 1}, {"kHz", 1e3}}},
      {Dimension::rotational_speed, "speed of rotation", {{"1/s", 1}, {"rpm", 1 / 60.}}},
      {Dimension::acceleration, "acceleration", {{"m/s2", 1}, {"mm/s2", 1e-3}, {"g", 9.80665}}},
      {Dimension::acceleration_density,
       "spectral density of acceleration",
       {{"(m/s2)2/Hz", 1}, {"g2/Hz", 9.80665 * 9.80665}}},
      {Dimension::force_density, "spectral density of force", {{"N2/Hz", 1}}},
      {Dimension::temperature, "temperature", {{"degC", 1}, {"C", 1}}}};
  return dimensions;
}

const DimensionInfo& info(Dimension dimension) {
  return table()[static_cast<std::size_t>(dimension)];
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

// "kg * m^2" and "kg m²" become "kgm2".
std::string plain(std::string_view unit) {
  std::string text(unit);
  for (const char* dropped : {" ", "\t", "*", "^", "·"}) replace_all(text, dropped, "");
  replace_all(text, "²", "2");
  replace_all(text, "³", "3");
  replace_all(text, "µ", "u");
  replace_all(text, "μ", "u");
  return text;
}

std::string article(const std::string& noun) {
  return (std::string("aeiou").find(noun.front()) != std::string::npos ? "an " : "a ") + noun;
}

std::string unit_list(Dimension dimension) {
  const std::vector<std::string> units = units_of(dimension);
  if (units.empty()) return "a number without unit";
  if (dimension == Dimension::ratio) return "a plain ratio or a number with %";
  std::string text = article(name_of(dimension)) + " in ";
  for (std::size_t i = 0; i < units.size(); ++i)
    text += (i == 0 ? "" : i + 1 == units.size() ? " or " : ", ") + units[i];
  return text + (units.size() > 1 ? " (plain number: " + units.front() + ")" : "");
}

std::string allowed(Dimension dimension) {
  return "allowed: " + unit_list(dimension);
}

// Dimension that knows this unit, as "a length"; empty if none does.
std::string owner(const std::string& unit) {
  for (const DimensionInfo& d : table())
    for (const Unit& u : d.units)
      if (plain(u.name) == unit) return article(d.name);
  return "";
}

} // namespace

std::vector<std::string> units_of(Dimension dimension) {
  std::vector<std::string> names;
  for (const Unit& unit : info(dimension).units) names.emplace_back(unit.name);
  return names;
}

std::string name_of(Dimension dimension) {
  return info(dimension).name;
}

std::string short_number(double value) {
  char buffer[32];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 6);
  return {buffer, end.ptr};
}

std::string millimetres(double length) {
  return short_number(length * 1000) + " mm";
}

ParsedQuantity parse_quantity(std::string_view text, Dimension dimension) {
  const std::string quoted = "'" + shown(text) + "'";
  std::string_view rest = text;
  while (!rest.empty() && (rest.front() == ' ' || rest.front() == '\t')) rest.remove_prefix(1);
  while (!rest.empty() && (rest.back() == ' ' || rest.back() == '\t')) rest.remove_suffix(1);
  if (rest.size() > 1 && rest[0] == '+' && rest[1] != '-') rest.remove_prefix(1);
  double value = 0;
  const auto [end, status] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  const bool yaml_special = rest.starts_with(".inf") || rest.starts_with("-.inf") ||
                            rest.starts_with(".nan") || rest.starts_with(".Inf") ||
                            rest.starts_with(".NaN") || rest.starts_with(".INF") ||
                            rest.starts_with(".NAN") || rest.starts_with("-.Inf");
  if (status == std::errc::result_out_of_range)
    return {0, quoted + " is beyond what a number can hold", allowed(dimension)};
  if (yaml_special || (status == std::errc() && !std::isfinite(value)))
    return {0, quoted + " is not a finite number", allowed(dimension)};
  if (status != std::errc()) return {0, quoted + " is not a number", allowed(dimension)};
  const std::string unit = plain(rest.substr(static_cast<std::size_t>(end - rest.data())));
  if (unit.empty()) return {value, "", ""};
  if (unit.front() == ',')
    return {0, quoted + " has a comma in the number", "write a decimal point"};
  for (const Unit& u : info(dimension).units)
    if (plain(u.name) == unit) {
      if (!std::isfinite(value * u.factor))
        return {0, quoted + " is beyond what a number can hold", allowed(dimension)};
      return {value * u.factor, "", ""};
    }
  const std::string other = owner(unit);
  if (!other.empty()) return {0, quoted + " is " + other, allowed(dimension)};
  const std::string near = nearest_word(unit, units_of(dimension));
  return {0, quoted + " has an unknown unit",
          (near.empty() ? "" : "did you mean '" + near + "'? ") + allowed(dimension)};
}

std::string describe(const Quantity& q, Dimension unit) {
  std::string bounds;
  if (std::isfinite(q.min))
    bounds += (q.exclusive_min ? " above " : " at least ") + short_number(q.min);
  if (std::isfinite(q.max))
    bounds += (bounds.empty() ? "" : " and") +
              std::string(q.exclusive_max ? " below " : " at most ") + short_number(q.max);
  return unit_list(unit) + (bounds.empty() ? "" : "," + bounds);
}

std::string quantity_pattern(Dimension dimension, bool negative, bool unit_alone) {
  std::string units;
  for (const std::string& name : units_of(dimension)) {
    std::string unit = name;
    replace_all(unit, " ", "[ *]*");
    units += (units.empty() ? "" : "|") + unit;
  }
  const std::string number = "([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][+-]?[0-9]+)?";
  const std::string unit = units.empty() ? "" : "( *(" + units + "))?";
  const std::string limit = " *[+-]?" + number + unit + " *";
  const std::string tolerance =
      " *([+]-|±) *" + number + "( *%|" + unit + ")|" + " *\\[" + limit + "," + limit + "\\]";
  return std::string(negative ? "^[+-]?" : "^[+]?") + number + unit + "(" + tolerance + ")?$" +
         (unit_alone ? "|^(" + units + ")$" : "");
}

} // namespace plica

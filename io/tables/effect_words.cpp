#include "io/tables/effect_words.hpp"

#include "diagnose/effects/effect.hpp"
#include "model/description/place_keys.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace plica {
namespace {

std::string with_unit(const std::string& number, const std::string& unit) {
  return number + (unit.empty() || unit == "°" ? "" : " ") + unit;
}

// Null: the effect has none. Where it has a size in each state, the first.
const EstimatedParameter* of_parameter(const NamedEffect& e, const std::string& name) {
  for (const EstimatedParameter& p : e.parameters)
    if (p.name == name || p.name.starts_with(name + ", ")) return &p;
  return nullptr;
}

// A parameter as a plain sentence asks for it: "mass", "loss%", "ratio+".
std::string value_words(const NamedEffect& e, std::string name) {
  const char form = name.back();
  if (form == '%' || form == '+') name.pop_back();
  const EstimatedParameter* p = of_parameter(e, name);
  if (!p) return "an amount";
  if (form == '%') return significant(100 * p->value, 2) + " %";
  if (form == '+') return with_sign(100 * (p->value - 1), 0) + " %";
  const ShownEstimate shown = shown_estimate(*p);
  const double value = shown.from_below ? shown.interval[0] : shown.value;
  const std::string words = with_unit(significant(rounded(value, 2), 2), shown.unit);
  return shown.from_below ? "anything from " + words + " up" : words;
}

// ", 0.38 m along": of what may sit anywhere along its part, or at places of a bellows; on a plate
// " and 0.05 m across" besides. ", within 0.02 m": of a spot on a surface, a deck or a damaged
// plate.
std::string along_words(const NamedEffect& e) {
  const EstimatedParameter *at = of_parameter(e, "at"), *across = of_parameter(e, "across");
  if (!at && e.within) return ", within " + significant(*e.within, 2) + " m";
  if (!at) return e.along ? ", " + significant(e.along->value, 3) + " m along" : "";
  return ", " + significant(at->value, 3) + " m along" +
         (across ? " and " + significant(across->value, 3) + " m across" : "");
}

} // namespace

std::string effect_label(const NamedEffect& e) {
  return e.name + (e.place.empty() ? "" : " at " + e.place) +
         (e.way.empty() ? "" : " (" + e.way + ")");
}

std::string hypothesis_label(const TriedHypothesis& h) {
  std::string label;
  for (const NamedEffect& e : h.effects) label += (label.empty() ? "" : " and ") + effect_label(e);
  return label.empty() ? "none" : label;
}

ShownUnit handy_unit(double value, const std::string& unit) {
  const double size = std::abs(value);
  if (unit == "m" && size < 1e-4) return {1e6, "µm"};
  if (unit == "m" && size < 0.1) return {1e3, "mm"};
  if (unit == "kg" && size < 0.1) return {1e3, "g"};
  if (unit == "rad") return {180 / std::numbers::pi, "°"};
  if (unit == "N/m" && size >= 1e7) return {1e-6, "MN/m"};
  return shown_unit(value, unit);
}

ShownEstimate shown_estimate(const EstimatedParameter& p) {
  constexpr double wide = 1e3;
  const bool from_below = p.interval[0] > 0 && p.interval[1] > wide * p.interval[0];
  const auto [factor, unit] = handy_unit(from_below ? p.interval[0] : p.value, p.unit);
  return {.value = factor * p.value,
          .interval = {factor * p.interval[0], factor * p.interval[1]},
          .unit = unit,
          .from_below = from_below};
}

std::string estimate_words(const EstimatedParameter& p, std::string (*number)(double, int)) {
  const ShownEstimate shown = shown_estimate(p);
  const auto [low, high] = shown.interval;
  if (shown.from_below) return with_unit("at least " + number(low, 2), shown.unit);
  const std::string value = number(shown.value, 3);
  return with_unit(low < high ? value + " (" + number(low, 3) + " to " + number(high, 3) + ")"
                              : value,
                   shown.unit);
}

std::string values_words(const NamedEffect& e, std::string (*number)(double, int),
                         std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(most, e.parameters.size()); ++i)
    text +=
        (i == 0 ? "" : ", ") + e.parameters[i].name + " " + estimate_words(e.parameters[i], number);
  return e.parameters.size() > most ? text + ", ..." : text;
}

std::string plain_words(const NamedEffect& e) {
  const Effect& effect = effect_named(e.name);
  const std::string& plain = !effect.plain_of_rigid.empty() && of_parameter(e, "stiffness")
                                 ? effect.plain_of_rigid
                                 : effect.plain;
  std::string text;
  for (std::size_t at = 0; at < plain.size();) {
    const std::size_t open = plain.find('{', at), close = plain.find('}', at);
    text += plain.substr(at, open - at);
    if (open == std::string::npos) break;
    text += value_words(e, plain.substr(open + 1, close - open - 1));
    at = close + 1;
  }
  return text;
}

namespace {

// Where it is as likely to be elsewhere, and no length says how far.
std::string elsewhere_words(const NamedEffect& e) {
  if (e.along || e.within || of_parameter(e, "at") || e.probability > 0.5 * e.anywhere) return "";
  std::vector<std::string> others = e.other_places;
  std::erase_if(others, [](const std::string& place) { // all of a kind at once
    return place == "clamps" || place == "joints" || place == all_mounts;
  });
  if (others.empty()) return "";
  return others.size() == 1 ? " or " + others.front()
                            : fmt::format(" or one of {} other places", others.size());
}

} // namespace

std::string plain_at_place(const NamedEffect& e) {
  const bool everywhere = e.place.empty() || e.place == "all";
  return plain_words(e) + (everywhere ? "" : ", at " + e.place + elsewhere_words(e)) +
         along_words(e) + (e.way.empty() ? "" : " (" + e.way + ")");
}

} // namespace plica

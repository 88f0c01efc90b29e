#include "io/write/simulated_yaml.hpp"

#include "lab/measured/measured_words.hpp"
#include "words/directions.hpp"
#include <fmt/format.h>

namespace plica {
namespace {

template <class List> std::string listed(const List& list) {
  std::string text;
  for (const auto& item : list) text += fmt::format("{}{}", text.empty() ? "" : ", ", item);
  return "[" + text + "]";
}

// A single-quoted scalar of YAML.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text)
    result += c == '\'' ? std::string("''") : std::string(1, c == '\n' ? ' ' : c);
  return result + "'";
}

std::string signed_axes_text(const std::vector<int>& axes) {
  std::vector<std::string> list;
  for (const int a : axes) list.push_back(signed_axis_word(a));
  return listed(list);
}

std::string optional_number(const char* key, const std::optional<double>& x) {
  return x ? fmt::format(", {}: {}", key, *x) : "";
}

std::string optional_text(const char* key, const std::string& text) {
  return text.empty() ? "" : fmt::format(", {}: {}", key, quoted(text));
}

std::string quoted_list(const std::vector<std::string>& texts) {
  std::vector<std::string> list;
  for (const std::string& t : texts) list.push_back(quoted(t));
  return listed(list);
}

std::string mode_text(const MeasuredMode& m) {
  std::string text = fmt::format("  - {{frequency: {}", m.frequency);
  text += optional_number("sigma", m.sigma) + optional_number("damping", m.damping) +
          optional_number("sigma_damping", m.sigma_damping);
  text += fmt::format(", shape: {}, order: {}", word_of(m.shape), m.order);
  if (m.direction) text += fmt::format(", direction: {}", word_of(*m.direction));
  if (m.base) text += fmt::format(", base: {}", word_of(*m.base));
  text += optional_number("level", m.level);
  if (!m.drive.empty()) text += ", drive: " + m.drive;
  text += optional_number("acceleration", m.acceleration) + optional_number("force", m.force);
  if (!m.sensor.empty()) text += ", sensor: " + m.sensor;
  text += optional_text("state", m.state) + optional_text("note", m.note);
  if (m.vector) {
    text += fmt::format(",\n     vector: {{channels: {}, real: {}", listed(m.vector->channels),
                        listed(m.vector->real));
    if (!m.vector->imaginary.empty()) text += ", imaginary: " + listed(m.vector->imaginary);
    text += "}";
  }
  return text + "}\n";
}

std::string peaks_text(const MeasuredPeaks& p) {
  std::string text = fmt::format(
      "  - {{base: {}, sensor: {}, direction: {}, level: {}, frequency: {}", word_of(p.base),
      p.sensor, word_of(p.direction), listed(p.level), listed(p.frequency));
  text += optional_number("sigma", p.sigma);
  if (!p.amplitude.empty()) text += ", amplitude: " + listed(p.amplitude);
  if (!p.damping.empty()) text += ", damping: " + listed(p.damping);
  return text + optional_text("state", p.state) + optional_text("note", p.note) + "}\n";
}

std::string states_text(const std::vector<MeasuredState>& states) {
  std::string text = states.empty() ? "" : "states:\n";
  for (const MeasuredState& s : states) {
    text += fmt::format("  - {{name: {}{}", s.name, s.baseline ? ", baseline: true" : "");
    std::string set;
    for (const auto& [path, value] : s.set)
      set += fmt::format("{}{}: {}", set.empty() ? "" : ", ", quoted(path), quoted(value));
    text += (set.empty() ? "" : ", set: {" + set + "}") + "}\n";
  }
  return text;
}

std::string weighings_text(const std::vector<MeasuredMass>& weighings) {
  std::string text = weighings.empty() ? "" : "mass:";
  for (const MeasuredMass& w : weighings)
    text += fmt::format("{} {{value: {}{}{}}}{}", weighings.size() > 1 ? "\n  -" : "", w.value,
                        optional_number("sigma", w.sigma), optional_text("state", w.state),
                        &w == &weighings.back() ? "\n" : "");
  return text;
}

} // namespace

std::string simulated_yaml(const Measured& m) {
  std::string text = fmt::format("specimen: {}\nsource: {}\n", m.specimen, quoted(m.source));
  if (!m.sensors.empty()) text += "sensors:\n";
  for (const MeasuredSensor& s : m.sensors)
    text +=
        fmt::format("  - {{name: {}, at: {}, axes: {}{}{}}}\n", s.name, listed(s.at),
                    signed_axes_text(s.axes), s.mass > 0 ? fmt::format(", mass: {}", s.mass) : "",
                    s.node > 0 ? fmt::format(", node: {}", s.node) : "");
  text += states_text(m.states);
  text += weighings_text(m.weighings);
  if (!m.statics.empty()) text += "static:\n";
  for (const MeasuredStatic& s : m.statics)
    text += fmt::format("  - {{direction: {}, value: {}{}{}{}{}}}\n", word_of(s.direction), s.value,
                        optional_number("sigma", s.sigma), optional_number("stroke", s.stroke),
                        optional_text("state", s.state), optional_text("note", s.note));
  if (!m.modes.empty()) text += "modes:\n";
  for (const MeasuredMode& mode : m.modes) text += mode_text(mode);
  if (!m.peaks.empty()) text += "peaks:\n";
  for (const MeasuredPeaks& p : m.peaks) text += peaks_text(p);
  if (!m.frf.empty()) text += "frf:\n";
  for (const MeasuredFrf& f : m.frf) {
    text += fmt::format("  - {{file: {}", quoted(f.file));
    if (f.base) text += fmt::format(", base: {}", word_of(*f.base));
    if (f.level) text += fmt::format(", level: {}", *f.level);
    text += "}\n";
  }
  if (!m.hold_out.empty()) text += "hold_out: " + quoted_list(m.hold_out) + "\n";
  if (!m.caveats.empty()) text += "caveats: " + quoted_list(m.caveats) + "\n";
  return text;
}

} // namespace plica

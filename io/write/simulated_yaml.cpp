#include "io/write/simulated_yaml.hpp"

#include "lab/measured/measured_words.hpp"
#include <fmt/format.h>

#include <array>

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

std::string axis_names(const std::vector<int>& numbers) {
  std::string text;
  for (const int a : numbers)
    text += fmt::format("{}{}{}", text.empty() ? "" : ", ", a < 0 ? "-" : "",
                        axis_word(std::abs(a) - 1));
  return "[" + text + "]";
}

std::string mode_text(const MeasuredMode& m) {
  std::string text = fmt::format("  - {{frequency: {}", m.frequency);
  if (m.sigma) text += fmt::format(", sigma: {}", *m.sigma);
  if (m.damping) text += fmt::format(", damping: {}", *m.damping);
  if (m.sigma_damping) text += fmt::format(", sigma_damping: {}", *m.sigma_damping);
  text += fmt::format(", shape: {}, order: {}", word_of(m.shape), m.order);
  if (m.direction) text += fmt::format(", direction: {}", word_of(*m.direction));
  if (m.base) text += fmt::format(", base: {}", word_of(*m.base));
  if (m.level) text += fmt::format(", level: {}", *m.level);
  if (!m.sensor.empty()) text += ", sensor: " + m.sensor;
  if (m.vector) {
    text += fmt::format(",\n     vector: {{channels: {}, real: {}", listed(m.vector->channels),
                        listed(m.vector->real));
    if (!m.vector->imaginary.empty()) text += ", imaginary: " + listed(m.vector->imaginary);
    text += "}";
  }
  return text + "}\n";
}

} // namespace

std::string simulated_yaml(const Measured& m) {
  std::string text = fmt::format("specimen: {}\nsource: {}\n", m.specimen, quoted(m.source));
  if (!m.sensors.empty()) text += "sensors:\n";
  for (const MeasuredSensor& s : m.sensors)
    text += fmt::format("  - {{name: {}, at: {}, axes: {}{}}}\n", s.name, listed(s.at),
                        axis_names(s.axes), s.node > 0 ? fmt::format(", node: {}", s.node) : "");
  if (m.mass) text += fmt::format("mass: {{value: {}}}\n", m.mass->value);
  if (!m.statics.empty()) text += "static:\n";
  for (const MeasuredStatic& s : m.statics)
    text += fmt::format("  - {{direction: {}, value: {}}}\n", word_of(s.direction), s.value);
  if (!m.modes.empty()) text += "modes:\n";
  for (const MeasuredMode& mode : m.modes) text += mode_text(mode);
  if (!m.frf.empty()) text += "frf:\n";
  for (const MeasuredFrf& f : m.frf) {
    text += fmt::format("  - {{file: {}", quoted(f.file));
    if (f.base) text += fmt::format(", base: {}", word_of(*f.base));
    if (f.level) text += fmt::format(", level: {}", *f.level);
    text += "}\n";
  }
  return text;
}

} // namespace plica

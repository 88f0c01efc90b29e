#include "diagnose/readings/reading_list.hpp"

#include "lab/measured/measured_words.hpp"
#include "words/directions.hpp"

#include <cmath>
#include <fmt/format.h>

namespace plica {

void ReadingList::add(Reading reading) {
  const bool is_component = reading.kind == ReadingKind::component;
  if (!is_component && !(reading.value > 0)) return;
  if (is_component)
    reading.log_value = reading.value;
  else if (reading.kind != ReadingKind::cross)
    reading.log_value = std::log(reading.value);
  reading.held_out = is_held_out(measured_, reading.entry);
  if (!reading.state.empty()) reading.name += ", " + reading.state;
  all.readings.push_back(std::move(reading));
}

double cross_value(double log_reading) {
  return std::max(0., std::exp(log_reading) - cross_floor);
}

double value_of(const Reading& reading, double log_value) {
  if (reading.kind == ReadingKind::component) return log_value;
  return reading.kind == ReadingKind::cross ? cross_value(log_value) : std::exp(log_value);
}

std::string word_of(const Input& input) {
  if (input.base >= 0) return std::string("base ") + axis_word(input.base);
  return input.force.empty() ? "" : "force at " + input.force;
}

std::string mode_name(const Reading& reading) {
  return std::string(word_of(reading.shape)) + " mode " + std::to_string(reading.order) +
         (reading.axis < 0 ? "" : std::string(" in ") + axis_word(reading.axis));
}

std::string at_level(const TestRun& run) {
  if (run.level == 0) return "";
  return fmt::format(", {:g} {}", run.level, run.by_force ? "N" : "m/s2");
}

std::string where_seen(const TestRun& run) {
  return "at " + run.sensor + " in " + axis_word(run.axis) + ", " + word_of(run.input) +
         at_level(run);
}

} // namespace plica

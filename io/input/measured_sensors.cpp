#include "io/input/measured_sensors.hpp"

#include "io/input/measured_states.hpp"
#include "lab/measured/measured_words.hpp"
#include "model/description/check_log.hpp"
#include "model/description/place_keys.hpp"
#include "words/did_you_mean.hpp"

#include <algorithm>

namespace plica {
namespace {

void check_beside_the_part(const MeasuredSensor& s, const std::string& key, ReadLog& log) {
  if (s.on.empty()) return;
  const bool is_place = s.on == on_the_table || is_at_mount(s.on) ||
                        (s.on.starts_with("supports[") && s.on.ends_with(']'));
  if (!is_place)
    log.add(key + ".on", "'" + shown(s.on) + "' is nothing beside the part",
            "table, mount.NAME or supports[i], as the case calls them");
}

} // namespace

void check_sensors(const Measured& m, ReadLog& log) {
  for (std::size_t i = 0; i < m.sensors.size(); ++i) {
    const MeasuredSensor& s = m.sensors[i];
    const std::string key = item("sensors", i);
    for (std::size_t j = 0; j < i; ++j)
      if (!s.name.empty() && m.sensors[j].name == s.name)
        log.add(key + ".name", "the name '" + shown(s.name) + "' is used by another sensor",
                "names must differ");
    if (s.axes.size() == 3 && !are_three_axes(s.axes))
      log.add(key + ".axes", "two axes of the sensor coincide", three_axes);
    check_beside_the_part(s, key, log);
  }
}

void check_driven(const Measured& m, const std::string& channel, const std::string& key,
                  ReadLog& log) {
  const std::string name(sensor_of_channel(channel));
  if (std::any_of(m.sensors.begin(), m.sensors.end(),
                  [&](const MeasuredSensor& s) { return s.name == name && !s.on.empty(); }))
    log.add(key, "'" + shown(name) + "' sits beside the part, where nothing drives it",
            "a sensor on the part, or base: the axis along which the table moved");
}

void weigh_sensors(Measured& m, ReadLog& log) {
  double sensors = 0;
  for (const MeasuredSensor& s : m.sensors)
    if (s.on.empty()) sensors += s.mass;
  for (std::size_t i = 0; i < m.weighings.size(); ++i) {
    if (!m.weighings[i].without_sensors) continue;
    if (sensors == 0)
      log.add(weighing_key(log, i) + ".without_sensors",
              "says that the sensors were not weighed, and none on the part has a mass",
              "sensors with a mass");
    m.weighings[i].value += sensors;
  }
}

} // namespace plica

#include "io/measured_file.hpp"

#include "diagnose/measured_fields.hpp"
#include "io/check_log.hpp"
#include "io/did_you_mean.hpp"
#include "io/field_reader.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace plica {

namespace {

int line(const ReadLog& log, const std::string& key) {
  const auto found = log.lines.find(key);
  return found == log.lines.end() ? 1 : found->second;
}

void check_sensors(const Measured& m, ReadLog& log) {
  for (std::size_t i = 0; i < m.sensors.size(); ++i) {
    const MeasuredSensor& s = m.sensors[i];
    const std::string key = item("sensors", i);
    for (std::size_t j = 0; j < i; ++j)
      if (!s.name.empty() && m.sensors[j].name == s.name)
        log.add(line(log, key + ".name"), key + ".name",
                "the name '" + shown(s.name) + "' is used by another sensor", "names must differ");
    if (s.axes.size() == 3 && !are_three_axes(s.axes))
      log.add(line(log, key + ".axes"), key + ".axes", "two axes of the sensor coincide",
              three_axes);
  }
}

void check_sensor_named(const Measured& m, const std::string& key, const std::string& name,
                        ReadLog& log) {
  std::vector<std::string> sensors;
  for (const MeasuredSensor& s : m.sensors) sensors.push_back(s.name);
  if (!name.empty() && std::find(sensors.begin(), sensors.end(), name) == sensors.end())
    log.add(line(log, key + ".sensor"), key + ".sensor", "there is no sensor '" + shown(name) + "'",
            sensors.empty() ? "this file has none" : suggestion(name, sensors));
}

void check_modes(const Measured& m, ReadLog& log) {
  for (std::size_t i = 0; i < m.modes.size(); ++i) {
    const std::string key = item("modes", i);
    check_sensor_named(m, key, m.modes[i].sensor, log);
    if (!m.modes[i].sensor.empty() && !m.modes[i].base)
      log.add(line(log, key), key, "has a sensor but no base, so no response it belongs to",
              "give the axis along which the table moved");
  }
}

void check_peaks(const Measured& m, ReadLog& log) {
  for (std::size_t i = 0; i < m.peaks.size(); ++i) {
    const MeasuredPeaks& p = m.peaks[i];
    const std::string key = item("peaks", i);
    check_sensor_named(m, key, p.sensor, log);
    const auto same_length = [&](const std::vector<double>& list, const char* name) {
      if (!list.empty() && !p.level.empty() && list.size() != p.level.size())
        log.add(line(log, key + "." + name), key + "." + name,
                "has " + std::to_string(list.size()) + " items for " +
                    std::to_string(p.level.size()) + " levels",
                "one item for each level");
    };
    same_length(p.frequency, "frequency");
    same_length(p.amplitude, "amplitude");
    same_length(p.damping, "damping");
  }
}

void check_files(const Measured& m, const std::string& path, ReadLog& log) {
  for (std::size_t i = 0; i < m.frf.size(); ++i) {
    const std::string key = item("frf", i) + ".file";
    const auto file = std::filesystem::path(path).parent_path() / m.frf[i].file;
    std::error_code ignored;
    if (!m.frf[i].file.empty() && !std::filesystem::is_regular_file(file, ignored))
      log.add(line(log, key), key, "there is no file '" + shown(m.frf[i].file) + "'",
              "give a path relative to this file");
  }
}

void check_hold_out(const Measured& m, ReadLog& log) {
  std::vector<std::string> entries;
  for (const auto& [key, where] : log.lines)
    for (const char* list : {"static[", "modes[", "peaks[", "frf["})
      if (key.starts_with(list) && key.find('.') == std::string::npos) entries.push_back(key);
  for (std::size_t i = 0; i < m.hold_out.size(); ++i)
    if (!log.lines.count(m.hold_out[i]) || !m.hold_out[i].ends_with(']'))
      log.add(line(log, item("hold_out", i)), item("hold_out", i),
              "there is no entry '" + shown(m.hold_out[i]) + "'",
              entries.empty() ? "this file has none" : suggestion(m.hold_out[i], entries));
}

} // namespace

Measured read_measured(const std::string& path) {
  ReadLog log{.file = path};
  const YamlNode root = read_yaml(path, log.problems);
  if (root.kind == YamlNode::Kind::null) throw InputError(std::move(log.problems));
  Measured data;
  FieldReader::read(root, "", data, log);
  check_sensors(data, log);
  check_modes(data, log);
  check_peaks(data, log);
  check_files(data, path, log);
  check_hold_out(data, log);
  for (const Tolerance& t : log.tolerances)
    log.add(line(log, t.path), t.path, "takes no tolerance", "give its sigma");
  if (!log.problems.empty()) {
    sort_by_line(log.problems);
    throw InputError(std::move(log.problems));
  }
  return data;
}

} // namespace plica

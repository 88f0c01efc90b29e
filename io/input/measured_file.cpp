#include "io/input/measured_file.hpp"

#include "io/input/field_reader.hpp"
#include "io/input/measured_orders.hpp"
#include "io/input/measured_sensors.hpp"
#include "io/input/measured_states.hpp"
#include "io/lab_files/stiffness_table.hpp"
#include "io/lab_files/universal_modes.hpp"
#include "lab/measured/entries.hpp"
#include "lab/measured/measured_fields.hpp"
#include "model/description/case_path.hpp"
#include "model/description/check_log.hpp"
#include "words/did_you_mean.hpp"
#include "words/units.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

namespace plica {

namespace {

void check_sensor_named(const Measured& m, const std::string& key, const std::string& name,
                        ReadLog& log) {
  std::vector<std::string> sensors;
  for (const MeasuredSensor& s : m.sensors) sensors.push_back(s.name);
  if (!name.empty() && std::find(sensors.begin(), sensors.end(), name) == sensors.end())
    log.add(key + ".sensor", "there is no sensor '" + shown(name) + "'",
            sensors.empty() ? "this file has none" : suggestion(name, sensors));
}

void check_peaks(const Measured& m, ReadLog& log) {
  for (std::size_t i = 0; i < m.peaks.size(); ++i) {
    const MeasuredPeaks& p = m.peaks[i];
    const std::string key = item("peaks", i);
    check_sensor_named(m, key, p.sensor, log);
    const auto same_length = [&](const std::vector<double>& list, const char* name) {
      if (!list.empty() && !p.level.empty() && list.size() != p.level.size())
        log.add(key + "." + name,
                "has " + std::to_string(list.size()) + " items for " +
                    std::to_string(p.level.size()) + " levels",
                "one item for each level");
    };
    same_length(p.frequency, "frequency");
    same_length(p.amplitude, "amplitude");
    same_length(p.damping, "damping");
  }
}

void check_file(const std::string& name, const std::string& key, const std::string& path,
                ReadLog& log) {
  const auto file = std::filesystem::path(path).parent_path() / name;
  std::error_code ignored;
  if (!name.empty() && !std::filesystem::is_regular_file(file, ignored))
    log.add(key, "there is no file '" + shown(name) + "'", "give a path relative to this file");
}

std::vector<std::string> sensor_channels(const Measured& m) {
  std::vector<std::string> known;
  for (const MeasuredSensor& s : m.sensors)
    for (const char* axis : {".x", ".y", ".z"}) known.push_back(s.name + axis);
  return known;
}

void check_channel(const std::vector<std::string>& known, const std::string& channel,
                   const std::string& place, ReadLog& log) {
  if (std::find(known.begin(), known.end(), channel) == known.end())
    log.add(place, "there is no sensor and axis '" + shown(channel) + "'",
            known.empty() ? "this file has no sensors" : suggestion(channel, known));
}

// "mid.y" of a sensor of this file, or "-". Inputs have names of their own.
void check_channels(const Measured& m, const std::vector<std::string>& channels,
                    const std::string& key, const std::string& input, ReadLog& log) {
  const std::vector<std::string> known = sensor_channels(m);
  std::set<std::string> seen;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const std::string place = item(key, i);
    if (channels[i] == "-") continue;
    if (!seen.insert(channels[i]).second)
      log.add(place, "channel '" + shown(channels[i]) + "' is there twice",
              "each channel once, - for one to leave out");
    const bool is_input =
        !input.empty() && (channels[i] == input || channels[i].starts_with("base."));
    if (!is_input) check_channel(known, channels[i], place, log);
  }
}

// What goes with an input that was measured, and what without.
void check_excitation(const MeasuredSignals& s, const std::string& key, ReadLog& log) {
  if (has_input(s.excitation)) {
    if (s.reference.empty() && log.lines.count(key + ".reference") == 0)
      log.add(key, "names no reference",
              "reference: channel of the input, such as base.y; without one excitation: "
              "free_decay or output_only");
    return;
  }
  const char* kind = s.excitation == SignalKind::free_decay ? "free_decay" : "output_only";
  const auto refuse = [&](bool given, const char* name, const char* allowed) {
    if (given) log.add(key + "." + name, std::string("does not go with ") + kind, allowed);
  };
  refuse(s.base.has_value(), "base", "nothing: no measured input drove the responses");
  refuse(s.quantity.has_value(), "quantity", "nothing: the responses are over no input");
  refuse(!s.force.empty(), "force", "nothing: no measured input drove the responses");
  if (s.excitation == SignalKind::output_only)
    refuse(!s.reference.empty(), "reference", "nothing, or excitation: random");
}

void check_responses(const Measured& m, const std::string& path, ReadLog& log) {
  for (std::size_t i = 0; i < m.frf.size(); ++i) {
    const MeasuredFrf& f = m.frf[i];
    const std::string key = item("frf", i);
    check_file(f.file, key + ".file", path, log);
    check_channels(m, f.channels, key + ".channels", "", log);
    if (!f.force.empty() && !m.sensors.empty())
      check_channels(m, {f.force}, key + ".force", "", log);
    check_driven(m, f.force, key + ".force", log);
    const bool asked = log.lines.count(key + ".base") > 0;
    if (asked == !f.force.empty())
      log.add(key, asked ? "has a base and a driven channel" : "says neither base nor force",
              "give the axis along which the table moved (base), or the channel that was driven "
              "(force)");
    if (f.base && f.quantity && *f.quantity != FrfQuantity::transmissibility)
      log.add(key + ".quantity", "does not go with motion of the base",
              "transmissibility, or force in place of base");
  }
  for (std::size_t i = 0; i < m.signals.size(); ++i) {
    const MeasuredSignals& s = m.signals[i];
    const std::string key = item("signals", i);
    check_file(s.file, key + ".file", path, log);
    check_channels(m, s.channels, key + ".channels", s.reference, log);
    if (!s.force.empty()) check_channels(m, {s.force}, key + ".force", "", log);
    check_driven(m, s.force, key + ".force", log);
    if (s.base && !s.force.empty())
      log.add(key, "has a base and a driven channel",
              "base, or force for the channel that was driven");
    check_excitation(s, key, log);
    if (!s.channels.empty() && !s.reference.empty() &&
        std::find(s.channels.begin(), s.channels.end(), s.reference) == s.channels.end())
      log.add(key + ".reference", "'" + shown(s.reference) + "' is none of the channels",
              suggestion(s.reference, s.channels));
  }
}

// Reads the tables too: they are small.
void read_stiffness(Measured& m, const std::string& path, ReadLog& log) {
  for (std::size_t i = 0; i < m.stiffness.size(); ++i) {
    MeasuredStiffnessTable& table = m.stiffness[i];
    const std::string key = item("stiffness", i);
    if (!table.ends.empty() && (table.ends.size() != 2 || table.ends[0] == table.ends[1]))
      log.add(key + ".ends", "are not two caps", "the end that moves, then the one that is held");
    const std::size_t before = log.problems.size();
    check_file(table.file, key + ".file", path, log);
    if (table.file.empty() || log.problems.size() > before) continue;
    try {
      table.numbers = read_stiffness_table(std::filesystem::path(path).parent_path() / table.file);
    } catch (const InputError& error) {
      log.problems.insert(log.problems.end(), error.problems().begin(), error.problems().end());
    }
  }
}

void check_vector(const Measured& m, const MeasuredVector& v, const std::string& key,
                  ReadLog& log) {
  if (!m.sensors.empty()) check_channels(m, v.channels, key + ".channels", "", log);
  const auto same_length = [&](const std::vector<double>& list, const char* name, bool required) {
    if ((required || !list.empty()) && list.size() != v.channels.size())
      log.add(key + "." + name,
              "has " + std::to_string(list.size()) + " items for " +
                  std::to_string(v.channels.size()) + " channels",
              "one item for each channel");
  };
  same_length(v.real, "real", true);
  same_length(v.imaginary, "imaginary", false);
}

// A shaker in place of the table.
void check_drive(const Measured& m, const MeasuredMode& mode, const std::string& key,
                 ReadLog& log) {
  const int levels = int(mode.acceleration.has_value()) + int(mode.force.has_value());
  if (mode.drive.empty()) {
    if (levels > 0)
      log.add(key, "has a level of a shaker but no place where it drove",
              "drive: sensor and axis, such as mid.y; `level` is that of a table");
    return;
  }
  check_channel(sensor_channels(m), mode.drive, key + ".drive", log);
  check_driven(m, mode.drive, key + ".drive", log);
  if (mode.base || mode.level)
    log.add(key, "has both a table and a shaker", "base and level, or drive and its level");
  if (levels != 1)
    log.add(key, levels == 0 ? "has a drive but no level" : "has two levels",
            "acceleration that was held at the drive, or force");
}

void check_modes(const Measured& m, ReadLog& log) {
  for (std::size_t i = 0; i < m.modes.size(); ++i) {
    const std::string key = item("modes", i);
    check_sensor_named(m, key, m.modes[i].sensor, log);
    if (m.modes[i].vector) check_vector(m, *m.modes[i].vector, key + ".vector", log);
    check_drive(m, m.modes[i], key, log);
    if (!m.modes[i].sensor.empty() && !m.modes[i].base)
      log.add(key, "has a sensor but no base, so no response it belongs to",
              "give the axis along which the table moved");
  }
}

// Standard deviation of single results stands in where no sigma is given.
void take_repeats(const std::vector<double>& repeats, double value, std::optional<double>& sigma,
                  const std::string& key, ReadLog& log) {
  if (repeats.size() < 2) return;
  double mean = 0, square = 0;
  for (double x : repeats) mean += x / double(repeats.size());
  for (double x : repeats) square += (x - mean) * (x - mean);
  const double scatter = std::sqrt(square / double(repeats.size() - 1));
  if (sigma)
    log.add(key + ".repeats", "stand beside a sigma", "give the single results or their sigma");
  else if (std::abs(value - mean) > scatter + 1e-9 * std::abs(mean))
    log.add(key + ".repeats", "do not scatter about the value",
            "single results whose mean is the value");
  else if (scatter > 0)
    sigma = scatter;
}

void take_all_repeats(Measured& m, ReadLog& log) {
  for (std::size_t i = 0; i < m.weighings.size(); ++i)
    take_repeats(m.weighings[i].repeats, m.weighings[i].value, m.weighings[i].sigma,
                 weighing_key(log, i), log);
  for (std::size_t i = 0; i < m.statics.size(); ++i)
    take_repeats(m.statics[i].repeats, m.statics[i].value, m.statics[i].sigma, item("static", i),
                 log);
  for (std::size_t i = 0; i < m.modes.size(); ++i)
    take_repeats(m.modes[i].repeats, m.modes[i].frequency, m.modes[i].sigma, item("modes", i), log);
}

void check_slopes(const Measured& m, ReadLog& log) {
  for (std::size_t i = 0; i < m.statics.size(); ++i)
    if (m.statics[i].slope == StaticSlope::tangent && !m.statics[i].stroke)
      log.add(item("static", i) + ".slope", "is that at a stroke, which is not stated",
              "a stroke beside it");
}

void check_hold_out(const Measured& m, ReadLog& log) {
  std::vector<std::string> entries;
  for (const auto& [key, where] : log.lines)
    for (const char* list : {"static[", "stiffness[", "modes[", "peaks[", "frf[", "signals["})
      if (key.starts_with(list) && key.find('.') == std::string::npos) entries.push_back(key);
  for (std::size_t i = 0; i < m.weighings.size(); ++i) entries.push_back(weighing_name(m, i));
  const auto is_entry = [&](const std::string& path) {
    if (!log.lines.contains(path)) return false;
    if (path.starts_with("mass[") && m.weighings.size() == 1) return false; // it is `mass`
    return path.ends_with(']') || path == "mass";
  };
  for (std::size_t i = 0; i < m.hold_out.size(); ++i)
    if (!is_entry(m.hold_out[i]))
      log.add(item("hold_out", i), "there is no entry '" + shown(m.hold_out[i]) + "'",
              entries.empty() ? "this file has none" : suggestion(m.hold_out[i], entries));
}

} // namespace

MeasuredFile read_measured_file(const std::string& path) {
  if (is_universal_file(path))
    return {.data = modes_of_universal(path), .path = path, .text = {}, .lines = {}};
  ReadLog log{.file = path};
  MeasuredFile file{.data = {}, .path = path, .text = {}, .lines = {}};
  YamlFile yaml = read_yaml(path, log.problems);
  const YamlNode& root = yaml.root;
  if (root.kind == YamlNode::Kind::null) throw InputError(std::move(log.problems));
  file.text = std::move(yaml.text);
  Measured& data = file.data;
  FieldReader::read(root, "", data, log);
  check_sensors(data, log);
  check_states(data, log);
  count_modes_of_no_kind(data, log);
  check_orders(data, log);
  check_baselines(data, log);
  check_modes(data, log);
  check_peaks(data, log);
  check_responses(data, path, log);
  read_stiffness(data, path, log);
  take_all_repeats(data, log);
  weigh_sensors(data, log);
  check_slopes(data, log);
  check_hold_out(data, log);
  for (const Tolerance& t : log.tolerances) log.add(t.path, "takes no tolerance", "give its sigma");
  if (!log.problems.empty()) {
    sort_by_line(log.problems, log.file);
    throw InputError(std::move(log.problems));
  }
  file.lines = std::move(log.lines);
  return file;
}

Measured read_measured(const std::string& path) {
  return read_measured_file(path).data;
}

std::optional<MeasuredFile> test_of(const CaseFile& file, const std::string& given) {
  const std::filesystem::path path = given;
  if (std::filesystem::is_directory(path))
    return read_measured_file((path / "measured.yaml").string());
  if (!given.empty()) return read_measured_file(given);
  if (file.data.measured.empty()) return std::nullopt;
  const std::filesystem::path beside = std::filesystem::path(file.path).parent_path();
  return read_measured_file((beside / file.data.measured).string());
}

void add_problems_of_test(const std::string& case_path, const std::string& model,
                          const Replacements& set, const std::string& given,
                          std::vector<InputProblem>& problems) {
  const auto is_of_test = [](const InputProblem& p) { return p.key == "measured"; };
  CaseFile file;
  file.path = case_path;
  file.data.measured = given.empty() ? test_named_in(case_path, model, set) : "";
  if (given.empty() && std::any_of(problems.begin(), problems.end(), is_of_test)) return;
  try {
    test_of(file, given);
  } catch (const InputError& error) {
    problems.insert(problems.end(), error.problems().begin(), error.problems().end());
  }
}

std::vector<std::filesystem::path> files_of(const MeasuredFile& file) {
  const std::filesystem::path beside = file.path.parent_path();
  std::vector<std::filesystem::path> files{file.path};
  for (const MeasuredStiffnessTable& s : file.data.stiffness) files.push_back(beside / s.file);
  for (const MeasuredFrf& f : file.data.frf) files.push_back(beside / f.file);
  for (const MeasuredSignals& s : file.data.signals) files.push_back(beside / s.file);
  return files;
}

void resolve_states(MeasuredFile& file, const CaseFile& asked) {
  std::vector<InputProblem> problems;
  Case copy = asked.data;
  std::vector<std::string> paths;
  for (const auto& [path, line] : asked.lines)
    if (quantity_at(copy, path)) paths.push_back(path);
  Measured& measured = file.data;
  constexpr int few = 3; // paths that are told where none is near
  for (std::size_t i = 0; i < measured.states.size(); ++i)
    for (const auto& set : measured.states[i].set) {
      const std::string &where = set.first, &text = set.second;
      const std::string key = item("states", i) + ".set";
      const auto add = [&](const std::string& wrong, const std::string& allowed) {
        for (const std::string& at : {key + "." + where, key})
          if (const auto line = file.lines.find(at); line != file.lines.end()) {
            problems.push_back({file.path.string(), line->second, key, wrong, allowed});
            return;
          }
        problems.push_back({file.path.string(), 0, key, wrong, allowed});
      };
      const std::optional<Quantity> number = quantity_at(copy, where);
      const ParsedQuantity parsed =
          number ? parse_quantity(text, number->unit)
                 : ParsedQuantity{.wrong = "the case has no number at '" + shown(where) + "'",
                                  .allowed = paths.empty() ? "the path of a number of the case"
                                                           : suggestion(where, paths, few)};
      if (!parsed.wrong.empty())
        add(parsed.wrong, parsed.allowed);
      else if (!allows(*number, parsed.value))
        add(where + " = " + shown(text) + " is not allowed", describe(*number, number->unit));
      else
        measured.states[i].numbers[where] = parsed.value;
    }
  if (problems.empty()) return;
  sort_by_line(problems, file.path.string());
  throw InputError(std::move(problems));
}

} // namespace plica

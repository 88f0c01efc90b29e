// Signals without a measured input, free decays and output-only runs, as measured.yaml names them.
#pragma once

#include "lab/identification/identify.hpp"
#include "lab/measured/measured.hpp"
#include "lab/signals/time_record.hpp"

#include <filesystem>

namespace plica {

// One identification: an output-only run, or the decays of one state and level at one set of
// channels.
struct TimeRun {
  SignalKind kind = SignalKind::output_only;
  std::vector<TimeRecord> records; // one an entry
  std::string force;               // channel of the hammer, or empty
  std::string state;
  std::optional<double> level;
  std::string key; // of its first entry
};

// A test with where it stands, so that errors name file and line.
struct TestOnFile {
  const Measured& data;
  const std::filesystem::path& path;
  const std::map<std::string, int>& lines; // of its keys
};

// Both throw InputError with file, line and key of what no mode can follow from.
std::vector<TimeRun> time_runs(const TestOnFile& test);
Identification identified(const TimeRun& run, const TestOnFile& test,
                          const IdentifySettings& settings);

} // namespace plica

#include "diagnose/readings/force_readings.hpp"

#include "lab/measured/measured_words.hpp"
#include "words/directions.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;

constexpr double strong_by_force = 0.1;  // of the highest peak of a response
constexpr std::size_t most_by_force = 5; // peaks of a response

// Frequencies of the modes that one state shows: those of peaks that lie together.
std::vector<double> modes_of(std::vector<double> peaks) {
  constexpr double together = 0.02;
  std::sort(peaks.begin(), peaks.end());
  std::vector<double> modes;
  for (std::size_t first = 0, n = 0; first < peaks.size(); first += n) {
    double sum = 0;
    for (n = 0; first + n < peaks.size() &&
                (n == 0 || std::log(peaks[first + n] / peaks[first + n - 1]) < together);
         ++n)
      sum += peaks[first + n];
    modes.push_back(sum / double(n));
  }
  return modes;
}

std::size_t nearest(const std::vector<double>& modes, double hertz) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < modes.size(); ++k)
    if (std::abs(std::log(modes[k] / hertz)) < std::abs(std::log(modes[best] / hertz))) best = k;
  return best;
}

} // namespace

ForceReadings::Channel ForceReadings::main_channel(const ResponseEntry& entry) const {
  const auto channel = [&](const std::string& sensor, int axis) {
    Channel found{sensor, axis, {}};
    if (const Index c = entry.column(sensor, axis); c >= 0)
      found.peaks = response_peaks(entry.set->hertz, entry.response(c), strong_by_force);
    return found;
  };
  const std::string driven = entry.input().force;
  if (const auto known = seen_in_.find(driven); known != seen_in_.end()) {
    Channel same = channel(known->second.first, known->second.second);
    if (!same.peaks.empty()) return same;
  }
  Channel best = channel(std::string(sensor_of_channel(driven)), axis_of_channel(driven));
  if (!best.peaks.empty()) return best;
  for (const std::string& sensor : entry.sensors())
    for (int axis = 0; axis < 3; ++axis)
      if (Channel other = channel(sensor, axis); highest_of(other.peaks) > highest_of(best.peaks))
        best = std::move(other);
  return best;
}

void ForceReadings::add(const ResponseEntry& entry) {
  Channel main = main_channel(entry);
  if (main.peaks.empty()) {
    list_.all.warnings.push_back(entry_name("frf", entry.number) +
                                 ": no peak in any response to the force");
    return;
  }
  seen_in_.try_emplace(entry.input().force, main.sensor, main.axis);
  if (main.peaks.size() > most_by_force) main.peaks.resize(most_by_force);
  TestRun run = entry.run();
  run.sensor = main.sensor;
  run.axis = main.axis;
  for (const FittedPeak& p : main.peaks) run.peaks.push_back(p.frequency);
  const int number = int(list_.all.runs.size());
  for (int k = 0; k < int(main.peaks.size()); ++k) {
    add_peak(entry, run, number, k, main.peaks[std::size_t(k)], list_);
    add_others(entry, run, k, main.peaks[std::size_t(k)]);
  }
  list_.all.runs.push_back(std::move(run));
}

// Where the peak is, over its height: the shape of its mode.
void ForceReadings::add_others(const ResponseEntry& entry, const TestRun& run, int peak,
                               const FittedPeak& found) {
  for (const std::string& sensor : entry.sensors())
    for (int axis = 0; axis < 3; ++axis) {
      const Index c = entry.column(sensor, axis);
      if (c < 0 || (sensor == run.sensor && axis == run.axis)) continue;
      const double height = entry.height_at(c, found);
      const double ratio = height / found.amplitude;
      if (!(ratio > 0)) continue;
      const double noise = entry.stated_noise(height);
      Reading reading = entry.blank(run, int(list_.all.runs.size()), peak);
      reading.kind = ReadingKind::cross;
      reading.sensor = sensor;
      reading.axis = axis;
      reading.name = "share at " + sensor + " in " + axis_word(axis) + " of peak " +
                     std::to_string(peak + 1) + ", " + word_of(run.input) + at_level(run);
      reading.value = ratio;
      reading.log_value = std::log(ratio + cross_floor);
      reading.sigma =
          std::hypot(0.03, std::hypot(found.noise, noise) * ratio / (ratio + cross_floor));
      list_.add(reading);
    }
}

void ForceReadings::number_modes() {
  std::vector<std::string> states;
  std::map<std::string, std::vector<double>> peaks;
  for (const TestRun& run : list_.all.runs) {
    if (run.input.force.empty()) continue;
    if (!peaks.contains(run.state)) states.push_back(run.state);
    std::vector<double>& own = peaks[run.state];
    own.insert(own.end(), run.peaks.begin(), run.peaks.end());
  }
  std::map<std::string, std::vector<int>> numbers; // of the modes of a state
  int count = 0;
  for (const std::string& state : states) {
    const std::vector<double> own = modes_of(peaks[state]);
    std::vector<int>& numbered = numbers[state];
    const std::vector<double> first = modes_of(peaks[states.front()]);
    constexpr double so_far = 0.35; // of the logarithm: what a change may move
    for (std::size_t k = 0; k < own.size(); ++k) {
      const std::size_t like = nearest(first, own[k]);
      const bool known = state != states.front() && nearest(own, first[like]) == k &&
                         std::abs(std::log(own[k] / first[like])) < so_far;
      numbered.push_back(known ? numbers[states.front()][like] : count++);
    }
  }
  for (Reading& r : list_.all.readings) {
    if (r.run < 0) continue;
    const TestRun& run = list_.all.runs[std::size_t(r.run)];
    if (run.input.force.empty()) continue;
    r.mode =
        numbers[run.state][nearest(modes_of(peaks[run.state]), run.peaks[std::size_t(r.peak)])];
  }
}

} // namespace plica

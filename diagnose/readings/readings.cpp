#include "diagnose/readings/readings.hpp"

#include "diagnose/readings/repeats.hpp"
#include "diagnose/readings/response_readings.hpp"
#include "diagnose/readings/shape_readings.hpp"
#include "diagnose/readings/stiffness_readings.hpp"
#include "lab/measured/measured_words.hpp"
#include "words/directions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace plica {
namespace {

constexpr double mass_sigma = 0.002, stiffness_sigma = 0.015, damping_sigma = 0.06,
                 amplitude_sigma = 0.05;

// Of a frequency that states none: a broad peak is known less well, by the root of its damping (Au,
// Mech. Syst. Signal Process. 48 (2014) 15-33: variance zeta / (4 pi cycles) at best).
double frequency_sigma(double damping) {
  constexpr double of_a_sharp_peak = 0.0025, sharp = 0.01;
  return of_a_sharp_peak * std::sqrt(std::max(1., damping / sharp));
}

double relative(const std::optional<double>& sigma, double value, double otherwise) {
  return sigma ? *sigma / value : otherwise;
}

class Collector {
public:
  explicit Collector(const TestData& test) : test_(test), measured_(test.data), list_(test.data) {}

  TestReadings collect() {
    numbers();
    std::string levels; // of modes that are known by their kind alone
    for (std::size_t i = 0; i < measured_.modes.size(); ++i)
      if (!measured_.modes[i].base) {
        mode_alone(i);
        if (measured_.modes[i].level)
          levels += (levels.empty() ? "" : ", ") + entry_name("modes", i);
      }
    if (!levels.empty())
      list_.all.warnings.push_back("the levels of " + levels +
                                   " say nothing without `base`: these modes are compared with the "
                                   "structure at rest, and what they differ by counts as scatter");
    add_stiffness_readings(measured_, list_);
    modes_of_runs();
    for (std::size_t i = 0; i < measured_.peaks.size(); ++i) peaks(i);
    add_response_readings(test_, list_);
    list_.all.level_sigma = measured_.level_sigma;
    widen_by_repeats(list_.all);
    hold_out_by_level();
    pool_repeats(list_.all);
    return std::move(list_.all);
  }

private:
  void numbers() {
    for (std::size_t i = 0; i < measured_.weighings.size(); ++i) {
      const MeasuredMass& w = measured_.weighings[i];
      list_.add({.kind = ReadingKind::mass,
                 .name = "mass",
                 .unit = "kg",
                 .entry = weighing_name(measured_, i),
                 .state = w.state,
                 .sensor = "",
                 .value = w.value,
                 .sigma = relative(w.sigma, w.value, mass_sigma),
                 .assumed = !w.sigma});
    }
    for (std::size_t i = 0; i < measured_.statics.size(); ++i) {
      const MeasuredStatic& k = measured_.statics[i];
      list_.add({.kind = ReadingKind::stiffness,
                 .name = stiffness_name(k.direction),
                 .unit = stiffness_unit(k.direction),
                 .entry = entry_name("static", i),
                 .state = k.state,
                 .sensor = "",
                 .direction = k.direction,
                 .stroke = k.stroke.value_or(0),
                 .tangent = k.slope == StaticSlope::tangent,
                 .value = k.value,
                 .sigma = relative(k.sigma, k.value, stiffness_sigma)});
    }
  }

  // A mode without excitation is known by its kind.
  void mode_alone(std::size_t i) {
    const MeasuredMode& m = measured_.modes[i];
    const TestRun driven{.state = m.state,
                         .level = m.acceleration.value_or(m.force.value_or(0)),
                         .by_force = m.force.has_value(),
                         .sensor = std::string(sensor_of_channel(m.drive)),
                         .axis = m.drive.empty() ? 0 : axis_of_channel(m.drive),
                         .peaks = {}};
    std::vector<TestRun>& runs = list_.all.runs;
    auto same = std::find_if(runs.begin(), runs.end(), [&](const TestRun& r) {
      return !r.input.any() && r.state == driven.state && r.level == driven.level &&
             r.by_force == driven.by_force && r.sensor == driven.sensor && r.axis == driven.axis;
    });
    if (same == runs.end()) same = runs.insert(same, driven);
    const int run = int(same - runs.begin());
    TestRun& own = *same;
    Reading reading{.kind = ReadingKind::frequency,
                    .name = "",
                    .unit = "Hz",
                    .entry = entry_name("modes", i),
                    .state = m.state,
                    .run = run,
                    .peak = int(own.peaks.size()),
                    .sensor = "",
                    .axis = m.direction ? static_cast<int>(*m.direction) : -1,
                    .shape = m.shape,
                    .order = m.order,
                    .value = m.frequency,
                    .sigma = relative(m.sigma, m.frequency, frequency_sigma(m.damping.value_or(0))),
                    .assumed = !m.sigma};
    own.peaks.push_back(m.frequency);
    reading.name = mode_name(reading);
    if (driven.level > 0) reading.name += at_level(driven) + " at " + m.drive;
    list_.add(reading);
    add_damping(reading, m.damping, m.sigma_damping);
    add_shape_readings(m, reading, list_);
  }

  void add_damping(Reading reading, const std::optional<double>& damping,
                   const std::optional<double>& sigma) {
    if (!damping || !(*damping > 0)) return;
    reading.kind = ReadingKind::damping;
    reading.paired_as = reading.value;
    reading.name = "damping of " + reading.name;
    reading.unit = "";
    reading.value = *damping;
    reading.sigma = relative(sigma, *damping, damping_sigma);
    reading.assumed = !sigma;
    list_.add(std::move(reading));
  }

  // Modes seen along one axis while the table moved belong to one run.
  void modes_of_runs() {
    std::vector<bool> done(measured_.modes.size());
    for (std::size_t i = 0; i < measured_.modes.size(); ++i) {
      const MeasuredMode& m = measured_.modes[i];
      if (!m.base || done[i]) continue;
      TestRun run{.state = m.state,
                  .input = {.base = static_cast<int>(*m.base), .force = ""},
                  .level = m.level.value_or(0),
                  .sensor = m.sensor,
                  .axis = static_cast<int>(m.direction.value_or(*m.base)),
                  .peaks = {},
                  .first = true};
      std::vector<std::size_t> own;
      for (std::size_t j = i; j < measured_.modes.size(); ++j) {
        const MeasuredMode& other = measured_.modes[j];
        const bool same = other.base == m.base && other.state == m.state &&
                          other.sensor == m.sensor && other.level == m.level &&
                          other.direction.value_or(*m.base) == m.direction.value_or(*m.base) &&
                          (j == i || other.order != m.order || !m.sensor.empty());
        if (!same) continue;
        done[j] = true;
        own.push_back(j);
      }
      std::sort(own.begin(), own.end(), [&](std::size_t a, std::size_t b) {
        return measured_.modes[a].frequency < measured_.modes[b].frequency;
      });
      for (std::size_t j : own) run.peaks.push_back(measured_.modes[j].frequency);
      for (std::size_t k = 0; k < own.size(); ++k) {
        const MeasuredMode& mode = measured_.modes[own[k]];
        Reading reading{.kind = ReadingKind::frequency,
                        .name = std::string("frequency in ") + axis_word(run.axis) + ", " +
                                word_of(run.input) + at_level(run),
                        .unit = "Hz",
                        .entry = entry_name("modes", own[k]),
                        .state = run.state,
                        .run = int(list_.all.runs.size()),
                        .peak = int(k),
                        .sensor = run.sensor,
                        .axis = run.axis,
                        .value = mode.frequency,
                        .sigma = relative(mode.sigma, mode.frequency,
                                          frequency_sigma(mode.damping.value_or(0))),
                        .assumed = !mode.sigma};
        list_.add(reading);
        add_damping(reading, mode.damping, mode.sigma_damping);
        add_shape_readings(mode, reading, list_);
      }
      list_.all.runs.push_back(std::move(run));
    }
  }

  void peaks(std::size_t i) {
    const MeasuredPeaks& p = measured_.peaks[i];
    for (std::size_t k = 0; k < p.level.size(); ++k) {
      const std::string index = "[" + std::to_string(k) + "]";
      TestRun run{.state = p.state,
                  .input = {.base = static_cast<int>(p.base), .force = ""},
                  .level = p.level[k],
                  .sensor = p.sensor,
                  .axis = static_cast<int>(p.direction),
                  .peaks = {p.frequency[k]},
                  .first = true};
      const std::string of = std::string(" of the first peak in ") + axis_word(run.axis) + ", " +
                             word_of(run.input) + at_level(run);
      Reading reading{.kind = ReadingKind::frequency,
                      .name = "frequency" + of,
                      .unit = "Hz",
                      .entry = entry_name("peaks", i) + ".frequency" + index,
                      .state = p.state,
                      .run = int(list_.all.runs.size()),
                      .sensor = p.sensor,
                      .axis = run.axis,
                      .value = p.frequency[k],
                      .sigma = relative(p.sigma, p.frequency[k],
                                        frequency_sigma(k < p.damping.size() ? p.damping[k] : 0)),
                      .assumed = !p.sigma};
      list_.add(reading);
      if (k < p.amplitude.size()) {
        reading.kind = ReadingKind::amplitude;
        reading.name = "amplitude" + of;
        reading.entry = entry_name("peaks", i) + ".amplitude" + index;
        reading.unit = "";
        reading.value = p.amplitude[k];
        reading.sigma = amplitude_sigma;
        list_.add(reading);
      }
      if (k < p.damping.size()) {
        reading.name = "frequency" + of;
        reading.entry = entry_name("peaks", i) + ".damping" + index;
        add_damping(reading, p.damping[k], std::nullopt);
      }
      list_.all.runs.push_back(std::move(run));
    }
  }

  // Without a word on it, the highest of three levels or more of one excitation is held out.
  void hold_out_by_level() {
    if (!measured_.hold_out.empty()) return;
    std::map<std::tuple<Input, std::string, int, bool>, std::set<double>> levels;
    const auto of = [&](const TestRun& run) -> std::set<double>& {
      return run.input.any() ? levels[{run.input, "", 0, false}]
                             : levels[{Input{}, run.sensor, run.axis, run.by_force}];
    };
    for (const TestRun& run : list_.all.runs)
      if (run.level > 0) of(run).insert(run.level);
    for (Reading& r : list_.all.readings) {
      if (r.run < 0) continue;
      const TestRun& run = list_.all.runs[std::size_t(r.run)];
      if (of(run).size() >= 3 && run.level == *of(run).rbegin()) r.held_out = true;
    }
  }

  const TestData& test_;
  const Measured& measured_;
  ReadingList list_;
};

} // namespace

TestReadings readings_of(const TestData& test) {
  return Collector(test).collect();
}

} // namespace plica

#include "diagnose/readings/response_readings.hpp"

#include "diagnose/readings/force_readings.hpp"
#include "lab/measured/measured_words.hpp"
#include "words/directions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace plica {
namespace {

using Eigen::Index;

constexpr double strong = 0.2;  // of the highest peak of a response
constexpr std::size_t most = 2; // peaks of a response

class ResponseReadings {
public:
  ResponseReadings(const TestData& test, ReadingList& list)
      : test_(test), measured_(test.data), list_(list) {}

  void collect() {
    for (std::size_t i = 0; i < test_.responses.size(); ++i)
      for (const FrfSet& set : test_.responses[i]) responses(i, set);
    forces_.number_modes();
    say_lost_peaks();
    cross_resonances();
    highest_along_other_axes();
  }

private:
  void responses(std::size_t i, const FrfSet& set) {
    for (int r = 0; r < int(set.references.size()); ++r) {
      const ResponseEntry entry{i, &measured_.frf[i], &set, r};
      if (entry.input().base >= 0)
        to_table(entry);
      else
        forces_.add(entry);
    }
  }

  void to_table(const ResponseEntry& entry) {
    std::vector<FittedPeak> peaks;
    TestRun run = entry.run();
    for (const std::string& sensor : entry.sensors()) {
      const Index c = entry.column(sensor, run.axis);
      if (c < 0) continue;
      const std::vector<FittedPeak> found =
          response_peaks(entry.set->hertz, entry.response(c), strong);
      if (highest_of(found) > highest_of(peaks)) {
        peaks = found;
        run.sensor = sensor;
      }
    }
    if (peaks.empty()) {
      list_.all.warnings.push_back(entry_name("frf", entry.number) +
                                   ": no peak along the axis of the base");
      return;
    }
    if (peaks.size() > most) peaks.resize(most);
    for (const FittedPeak& p : peaks) run.peaks.push_back(p.frequency);
    const auto number = int(list_.all.runs.size());
    for (std::size_t k = 0; k < peaks.size(); ++k)
      add_peak(entry, run, number, int(k), peaks[k], list_);
    for (const std::string& sensor : entry.sensors()) add_others(entry, run, sensor, peaks.front());
    const auto high = [](const FittedPeak& a, const FittedPeak& b) {
      return a.amplitude < b.amplitude;
    };
    sources_.push_back({entry, list_.all.runs.size(),
                        std::max_element(peaks.begin(), peaks.end(), high)->frequency});
    list_.all.runs.push_back(std::move(run));
  }

  // Peaks are held against the model's one by one, so that one that is gone is in no reading: the
  // highest of a level that is not near any peak of the next.
  void say_lost_peaks() {
    constexpr double near = 0.35; // of the logarithm: what slips may come so far in a step
    for (const Source& own : sources_) {
      const TestRun& run = list_.all.runs[own.run];
      const Source* next = nullptr;
      for (const Source& other : sources_) {
        const TestRun& at = list_.all.runs[other.run];
        if (at.state != run.state || at.input != run.input || !(at.level > run.level)) continue;
        if (!next || at.level < list_.all.runs[next->run].level) next = &other;
      }
      if (!next) continue;
      const TestRun& at = list_.all.runs[next->run];
      const bool swept = own.highest > at.band[0] && own.highest < at.band[1];
      if (!swept || std::any_of(at.peaks.begin(), at.peaks.end(), [&](double hertz) {
            return std::abs(std::log(hertz / own.highest)) < near;
          }))
        continue;
      list_.all.warnings.push_back(fmt::format(
          "{}: the highest peak at {:g} m/s2, {:.4g} Hz, is not among those at {:g} m/s2: "
          "something that no reading holds changes with the level",
          entry_name("frf", next->entry.number), run.level, own.highest, at.level));
    }
  }

  // What shows along another axis where that axis resonates, over the height of the resonance when
  // the table moves along it.
  void cross_resonances() {
    for (const Source& own : sources_)
      for (const Source& other : sources_) {
        const TestRun &run = list_.all.runs[own.run], &at = list_.all.runs[other.run];
        if (run.input == at.input || run.state != at.state || run.level != at.level) continue;
        const Index c = own.entry.column(at.sensor, at.axis);
        const Index main = other.entry.column(at.sensor, at.axis);
        // Beside a band that ends in its flank a resonance would look smaller than it is.
        const double resonance = at.peaks.front();
        if (c < 0 || main < 0 || !own.entry.covers(resonance, resonance_window)) continue;
        const double height = other.entry.largest(main, resonance, resonance_window);
        const double ratio = own.entry.largest(c, resonance, resonance_window) / height;
        if (!(height > 0 && ratio > 0)) continue;
        const double noise = own.entry.stated_noise(ratio * height);
        Reading reading = own.entry.blank(run, int(own.run), 0);
        reading.at_run = int(other.run);
        reading.kind = ReadingKind::cross;
        reading.sensor = at.sensor;
        reading.axis = at.axis;
        reading.name = std::string("share in ") + axis_word(at.axis) + " at its resonance, " +
                       word_of(run.input) + at_level(run);
        reading.value = ratio;
        reading.log_value = std::log(ratio + cross_floor);
        reading.sigma = std::hypot(0.03, noise * ratio / (ratio + cross_floor));
        list_.add(reading);
      }
  }

  // Along an axis that the table is never moved along in this state: the highest of the band.
  void highest_along_other_axes() {
    for (const Source& own : sources_) {
      const TestRun& run = list_.all.runs[own.run];
      for (int axis = 0; axis < 3; ++axis) {
        if (std::any_of(list_.all.runs.begin(), list_.all.runs.end(), [&](const TestRun& other) {
              return other.input.base == axis && other.state == run.state;
            }))
          continue;
        const Index main = own.entry.column(run.sensor, run.axis),
                    c = own.entry.column(run.sensor, axis);
        if (c < 0) continue;
        const double height = own.entry.response(main).cwiseAbs().maxCoeff(),
                     ratio = own.entry.response(c).cwiseAbs().maxCoeff() / height;
        Reading reading = own.entry.blank(run, int(own.run), 0);
        reading.kind = ReadingKind::cross;
        reading.highest = true;
        reading.axis = axis;
        reading.name = std::string("highest in ") + axis_word(axis) + " over that in " +
                       axis_word(run.axis) + at_level(run);
        reading.value = ratio;
        reading.log_value = std::log(ratio + cross_floor);
        const double noise = own.entry.stated_noise(ratio * height);
        reading.sigma = std::hypot(0.03, noise * ratio / (ratio + cross_floor));
        list_.add(reading);
      }
    }
  }

  // Height at the first peak of the other sensors, and what all show along the other axes.
  void add_others(const ResponseEntry& entry, const TestRun& run, const std::string& sensor,
                  const FittedPeak& peak) {
    const Index main = entry.column(sensor, run.axis);
    if (main < 0) return;
    const double height = entry.height_at(main, peak);
    if (!(height > 0)) return;
    const double noise = entry.stated_noise(height);
    Reading reading = entry.blank(run, int(list_.all.runs.size()), 0);
    reading.sensor = sensor;
    const std::string of = " at " + sensor + ", " + word_of(run.input) + at_level(run);
    if (sensor != run.sensor) {
      reading.kind = ReadingKind::amplitude;
      reading.name = std::string("amplitude") + of;
      reading.value = height;
      reading.sigma = std::hypot(0.02, noise);
      list_.add(reading);
    }
    for (int axis = 0; axis < 3; ++axis) {
      const Index c = axis == run.axis ? -1 : entry.column(sensor, axis);
      if (c < 0) continue;
      const double ratio =
          std::max(entry.largest(c, peak.frequency, cross_window), entry.height_at(c, peak)) /
          height;
      reading.kind = ReadingKind::cross;
      reading.axis = axis;
      reading.name = std::string("share in ") + axis_word(axis) + of;
      reading.value = std::max(ratio, 1e-9);
      reading.log_value = std::log(ratio + cross_floor);
      reading.sigma = std::hypot(0.03, std::hypot(noise, noise * 0.5 / (ratio + cross_floor)));
      list_.add(reading);
    }
  }

  struct Source { // of a run from a response
    ResponseEntry entry;
    std::size_t run = 0;
    double highest = 0; // Hz, of its peaks
  };

  const TestData& test_;
  const Measured& measured_;
  ReadingList& list_;
  ForceReadings forces_{list_};
  std::vector<Source> sources_;
};

} // namespace

void add_response_readings(const TestData& test, ReadingList& list) {
  ResponseReadings(test, list).collect();
}

} // namespace plica

#include "diagnose/readings/response_readings.hpp"

#include "diagnose/readings/response_peaks.hpp"
#include "lab/measured/measured_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/printf.h>

namespace plica {
namespace {

using Eigen::Index;

constexpr double strong = 0.2;  // of the highest peak of a response
constexpr std::size_t most = 2; // peaks of a response

class ResponseReadings {
public:
  ResponseReadings(const DiagnosisData& test, ReadingList& list)
      : test_(test), measured_(test.data), list_(list) {}

  void collect() {
    for (std::size_t i = 0; i < test_.responses.size(); ++i)
      for (const FrfSet& set : test_.responses[i]) responses(i, set);
    say_lost_peaks();
    cross_resonances();
    highest_along_other_axes();
  }

private:
  // Column of a channel of a set; -1 = not there.
  static Index column(const FrfSet& set, const std::string& sensor, int axis) {
    const std::string name = sensor + "." + axis_word(axis);
    const auto found = std::find(set.responses.begin(), set.responses.end(), name);
    return found == set.responses.end() ? -1 : found - set.responses.begin();
  }

  static std::vector<std::string> sensors_of(const FrfSet& set) {
    std::vector<std::string> names;
    for (const std::string& channel : set.responses)
      if (const std::string name = channel.substr(0, channel.rfind('.'));
          std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
    return names;
  }

  // Relative noise of a response near its peaks, as stated; else none.
  double stated_noise(std::size_t i, double amplitude) const {
    const auto& sigma = measured_.frf[i].sigma;
    return sigma ? std::hypot(sigma->relative, sigma->floor / amplitude) : 0;
  }

  void responses(std::size_t i, const FrfSet& set) {
    for (std::size_t r = 0; r < set.references.size(); ++r) {
      if (!set.references[r].starts_with("base.")) {
        list_.all.warnings.push_back(
            entry_name("frf", i) +
            ": a response to a force is not taken; identify its modes (plica "
            "identify) and state them as modes");
        continue;
      }
      response(i, set, int(r), int(set.references[r].back() - 'x'));
    }
  }

  void response(std::size_t i, const FrfSet& set, int reference, int base) {
    const Eigen::MatrixXcd& H = set.H[std::size_t(reference)];
    const MeasuredFrf& own = measured_.frf[i];
    std::vector<FittedPeak> peaks;
    TestRun run{.state = own.state,
                .base = base,
                .level = own.level.value_or(0),
                .sensor = "",
                .axis = base,
                .peaks = {},
                .band = {set.hertz[0], set.hertz[set.hertz.size() - 1]}};
    for (const std::string& sensor : sensors_of(set)) {
      const Index c = column(set, sensor, base);
      if (c < 0) continue;
      const std::vector<FittedPeak> found = response_peaks(set.hertz, H.col(c), strong);
      const auto highest = [](const std::vector<FittedPeak>& all) {
        double value = 0;
        for (const FittedPeak& p : all) value = std::max(value, p.amplitude);
        return value;
      };
      if (highest(found) > highest(peaks)) {
        peaks = found;
        run.sensor = sensor;
      }
    }
    if (peaks.empty()) {
      list_.all.warnings.push_back(entry_name("frf", i) + ": no peak along the axis of the base");
      return;
    }
    if (peaks.size() > most) peaks.resize(most);
    for (const FittedPeak& p : peaks) run.peaks.push_back(p.frequency);
    for (std::size_t k = 0; k < peaks.size(); ++k) add_main(i, set, run, int(k), peaks[k]);
    for (const std::string& sensor : sensors_of(set))
      add_others(i, set, H, run, sensor, peaks.front());
    const auto high = [](const FittedPeak& a, const FittedPeak& b) {
      return a.amplitude < b.amplitude;
    };
    sources_.push_back({i, &set, reference, list_.all.runs.size(),
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
        if (at.state != run.state || at.base != run.base || !(at.level > run.level)) continue;
        if (!next || at.level < list_.all.runs[next->run].level) next = &other;
      }
      if (!next) continue;
      const TestRun& at = list_.all.runs[next->run];
      const bool swept = own.highest > at.band[0] && own.highest < at.band[1];
      if (!swept || std::any_of(at.peaks.begin(), at.peaks.end(), [&](double hertz) {
            return std::abs(std::log(hertz / own.highest)) < near;
          }))
        continue;
      const std::string text =
          fmt::sprintf("%s: the highest peak at %g m/s2, %.4g Hz, is not among those at %g m/s2: "
                       "something that no reading holds changes with the level",
                       entry_name("frf", next->entry).c_str(), run.level, own.highest, at.level);
      list_.all.warnings.emplace_back(text);
    }
  }

  // What shows along another axis where that axis resonates, over the height of the resonance when
  // the table moves along it.
  void cross_resonances() {
    for (const Source& own : sources_)
      for (const Source& other : sources_) {
        const TestRun &run = list_.all.runs[own.run], &at = list_.all.runs[other.run];
        if (run.base == at.base || run.state != at.state || run.level != at.level) continue;
        const Index c = column(*own.set, at.sensor, at.base);
        const Index main = column(*other.set, at.sensor, at.base);
        if (c < 0 || main < 0) continue;
        const double height = largest_near(*other.set, other.reference, main, at.peaks.front());
        const double ratio = largest_near(*own.set, own.reference, c, at.peaks.front()) / height;
        if (!(height > 0 && ratio > 0)) continue;
        const double noise = stated_noise(own.entry, ratio * height);
        Reading reading = blank(own.entry, run, 0);
        reading.run = int(own.run);
        reading.at_run = int(other.run);
        reading.kind = ReadingKind::cross;
        reading.sensor = at.sensor;
        reading.axis = at.base;
        reading.name = std::string("share in ") + axis_word(at.base) + " at its resonance, base " +
                       axis_word(run.base) + at_level(run);
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
              return other.base == axis && other.state == run.state;
            }))
          continue;
        const Index main = column(*own.set, run.sensor, run.base),
                    c = column(*own.set, run.sensor, axis);
        if (c < 0) continue;
        const Eigen::MatrixXcd& H = own.set->H[std::size_t(own.reference)];
        const double height = H.col(main).cwiseAbs().maxCoeff(),
                     ratio = H.col(c).cwiseAbs().maxCoeff() / height;
        Reading reading = blank(own.entry, run, 0);
        reading.run = int(own.run);
        reading.kind = ReadingKind::cross;
        reading.highest = true;
        reading.axis = axis;
        reading.name = std::string("highest in ") + axis_word(axis) + " over that in " +
                       axis_word(run.base) + at_level(run);
        reading.value = ratio;
        reading.log_value = std::log(ratio + cross_floor);
        const double noise = stated_noise(own.entry, ratio * height);
        reading.sigma = std::hypot(0.03, noise * ratio / (ratio + cross_floor));
        list_.add(reading);
      }
    }
  }

  static double largest_near(const FrfSet& set, int reference, Index c, double hertz) {
    double value = 0;
    for (Index k = 0; k < set.hertz.size(); ++k)
      if (std::abs(set.hertz[k] / hertz - 1) <= resonance_window)
        value = std::max(value, std::abs(set.H[std::size_t(reference)](k, c)));
    return value;
  }

  Reading blank(std::size_t i, const TestRun& run, int peak) const {
    return {.name = "",
            .unit = "",
            .entry = entry_name("frf", i),
            .state = run.state,
            .run = int(list_.all.runs.size()),
            .peak = peak,
            .sensor = run.sensor,
            .axis = run.axis};
  }

  void add_main(std::size_t i, const FrfSet& set, const TestRun& run, int k,
                const FittedPeak& peak) {
    const std::string of = " of peak " + std::to_string(k + 1) + " at " + run.sensor + " in " +
                           axis_word(run.axis) + ", base " + axis_word(run.base) + at_level(run);
    const double step = (set.hertz[set.hertz.size() - 1] - set.hertz[0]) /
                        double(std::max<Index>(1, set.hertz.size() - 1)) / peak.frequency;
    // Of what a fit finds from so many lines: relative to height, half of it to width.
    const double noise = std::max(peak.noise, stated_noise(i, peak.amplitude)) /
                         std::sqrt(std::max(1., peak.lines / 4.));
    Reading reading = blank(i, run, k);
    reading.kind = ReadingKind::frequency;
    reading.name = "frequency" + of;
    reading.unit = "Hz";
    reading.value = peak.frequency;
    reading.sigma = std::max(peak.damping * noise, 0.05 * step);
    list_.add(reading);
    reading.kind = ReadingKind::damping;
    reading.name = "damping" + of;
    reading.unit = "";
    reading.value = peak.damping;
    reading.sigma = std::hypot(0.005, 2 * noise);
    list_.add(reading);
    reading.kind = ReadingKind::amplitude;
    reading.name = "amplitude" + of;
    reading.value = peak.amplitude;
    reading.sigma = std::hypot(0.005, noise);
    list_.add(reading);
  }

  // Height at the first peak of the other sensors, and what all show along the other axes.
  void add_others(std::size_t i, const FrfSet& set, const Eigen::MatrixXcd& H, const TestRun& run,
                  const std::string& sensor, const FittedPeak& peak) {
    const Index main = column(set, sensor, run.base);
    if (main < 0) return;
    const auto largest = [&](Index c, double window) {
      double value = 0;
      for (Index k = 0; k < set.hertz.size(); ++k)
        if (std::abs(set.hertz[k] / peak.frequency - 1) <= window)
          value = std::max(value, std::abs(H(k, c)));
      return value;
    };
    const double height = largest(main, std::max(2 * peak.damping, 0.01));
    if (!(height > 0)) return;
    const double noise = stated_noise(i, height);
    Reading reading = blank(i, run, 0);
    reading.sensor = sensor;
    const std::string of = " at " + sensor + ", base " + axis_word(run.base) + at_level(run);
    if (sensor != run.sensor) {
      reading.kind = ReadingKind::amplitude;
      reading.name = std::string("amplitude") + of;
      reading.value = height;
      reading.sigma = std::hypot(0.02, noise);
      list_.add(reading);
    }
    for (int axis = 0; axis < 3; ++axis) {
      const Index c = axis == run.base ? -1 : column(set, sensor, axis);
      if (c < 0) continue;
      const double ratio = largest(c, cross_window) / height;
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
    std::size_t entry = 0;
    const FrfSet* set = nullptr;
    int reference = 0;
    std::size_t run = 0;
    double highest = 0; // Hz, of its peaks
  };

  const DiagnosisData& test_;
  const Measured& measured_;
  ReadingList& list_;
  std::vector<Source> sources_;
};

} // namespace

void add_response_readings(const DiagnosisData& test, ReadingList& list) {
  ResponseReadings(test, list).collect();
}

} // namespace plica

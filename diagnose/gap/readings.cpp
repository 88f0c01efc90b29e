#include "diagnose/gap/readings.hpp"

#include "diagnose/gap/repeats.hpp"
#include "diagnose/gap/response_peaks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr double mass_sigma = 0.002, stiffness_sigma = 0.015, frequency_sigma = 0.0025,
                 damping_sigma = 0.06, amplitude_sigma = 0.05;
constexpr double strong = 0.2;  // of the highest peak of a response
constexpr std::size_t most = 2; // peaks of a response
constexpr std::array letters{"x", "y", "z"};

std::string entry(const char* list, std::size_t i) {
  return std::string(list) + "[" + std::to_string(i) + "]";
}

std::string at_level(double level) {
  if (level == 0) return "";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), ", %g m/s2", level);
  return text.data();
}

const char* static_name(StaticDirection direction) {
  constexpr std::array names{"axial stiffness",        "transverse stiffness x",
                             "transverse stiffness z", "bending stiffness x",
                             "bending stiffness z",    "torsional stiffness"};
  return names[static_cast<std::size_t>(direction)];
}

const char* shape_name(MeasuredShape shape) {
  constexpr std::array names{"axial", "transverse", "torsion", "shell", "other"};
  return names[static_cast<std::size_t>(shape)];
}

double relative(const std::optional<double>& sigma, double value, double otherwise) {
  return sigma ? *sigma / value : otherwise;
}

class Collector {
public:
  explicit Collector(const DiagnosisData& test) : test_(test), measured_(test.data) {}

  TestReadings collect() {
    numbers();
    for (std::size_t i = 0; i < measured_.modes.size(); ++i)
      if (!measured_.modes[i].base) mode_alone(i);
    modes_of_runs();
    for (std::size_t i = 0; i < measured_.peaks.size(); ++i) peaks(i);
    for (std::size_t i = 0; i < test_.responses.size(); ++i)
      for (const FrfSet& set : test_.responses[i]) responses(i, set);
    cross_resonances();
    highest_along_other_axes();
    widen_by_repeats(all_);
    hold_out_by_level();
    return std::move(all_);
  }

private:
  bool held_out(const std::string& where) const {
    return std::any_of(
        measured_.hold_out.begin(), measured_.hold_out.end(), [&](const std::string& h) {
          return where == h || where.starts_with(h + ".") || where.starts_with(h + "[");
        });
  }

  void add(Reading reading) {
    if (!(reading.value > 0)) return;
    if (reading.kind != ReadingKind::cross) reading.log_value = std::log(reading.value);
    reading.held_out = held_out(reading.entry);
    if (!reading.state.empty()) reading.name += ", " + reading.state;
    all_.readings.push_back(std::move(reading));
  }

  void numbers() {
    if (const auto& mass = measured_.mass)
      add({.kind = ReadingKind::mass,
           .name = "mass",
           .unit = "kg",
           .entry = "mass",
           .state = "",
           .sensor = "",
           .value = mass->value,
           .sigma = relative(mass->sigma, mass->value, mass_sigma)});
    for (std::size_t i = 0; i < measured_.statics.size(); ++i) {
      const MeasuredStatic& k = measured_.statics[i];
      add({.kind = ReadingKind::stiffness,
           .name = static_name(k.direction),
           .unit = k.direction >= StaticDirection::bending_x ? "Nm/rad" : "N/m",
           .entry = entry("static", i),
           .state = k.state,
           .sensor = "",
           .direction = k.direction,
           .stroke = k.stroke.value_or(0),
           .value = k.value,
           .sigma = relative(k.sigma, k.value, stiffness_sigma)});
    }
  }

  // A mode without excitation is known by its kind.
  void mode_alone(std::size_t i) {
    const MeasuredMode& m = measured_.modes[i];
    int run = 0;
    while (run < int(all_.runs.size()) &&
           (all_.runs[std::size_t(run)].base >= 0 || all_.runs[std::size_t(run)].state != m.state))
      ++run;
    if (run == int(all_.runs.size()))
      all_.runs.push_back({.state = m.state, .sensor = "", .peaks = {}});
    TestRun& own = all_.runs[std::size_t(run)];
    Reading reading{.kind = ReadingKind::frequency,
                    .name = std::string(shape_name(m.shape)) + " mode " + std::to_string(m.order),
                    .unit = "Hz",
                    .entry = entry("modes", i),
                    .state = m.state,
                    .run = run,
                    .peak = int(own.peaks.size()),
                    .sensor = "",
                    .axis = m.direction ? static_cast<int>(*m.direction) : -1,
                    .shape = m.shape,
                    .order = m.order,
                    .value = m.frequency,
                    .sigma = relative(m.sigma, m.frequency, frequency_sigma),
                    .assumed = !m.sigma};
    own.peaks.push_back(m.frequency);
    if (m.direction) reading.name += std::string(" in ") + letters[std::size_t(reading.axis)];
    add(reading);
    add_damping(reading, m.damping, m.sigma_damping);
  }

  void add_damping(Reading reading, const std::optional<double>& damping,
                   const std::optional<double>& sigma) {
    if (!damping || !(*damping > 0)) return;
    reading.kind = ReadingKind::damping;
    reading.name = "damping of " + reading.name.substr(0, reading.name.find(", " + reading.state));
    reading.unit = "";
    reading.value = *damping;
    reading.sigma = relative(sigma, *damping, damping_sigma);
    reading.assumed = !sigma;
    add(std::move(reading));
  }

  // Modes seen along one axis while the table moved belong to one run.
  void modes_of_runs() {
    std::vector<bool> done(measured_.modes.size());
    for (std::size_t i = 0; i < measured_.modes.size(); ++i) {
      const MeasuredMode& m = measured_.modes[i];
      if (!m.base || done[i]) continue;
      TestRun run{.state = m.state,
                  .base = static_cast<int>(*m.base),
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
                        .name = std::string("frequency in ") + letters[std::size_t(run.axis)] +
                                ", base " + letters[std::size_t(run.base)] + at_level(run.level),
                        .unit = "Hz",
                        .entry = entry("modes", own[k]),
                        .state = run.state,
                        .run = int(all_.runs.size()),
                        .peak = int(k),
                        .sensor = run.sensor,
                        .axis = run.axis,
                        .value = mode.frequency,
                        .sigma = relative(mode.sigma, mode.frequency, frequency_sigma),
                        .assumed = !mode.sigma};
        add(reading);
        add_damping(reading, mode.damping, mode.sigma_damping);
      }
      all_.runs.push_back(std::move(run));
    }
  }

  void peaks(std::size_t i) {
    const MeasuredPeaks& p = measured_.peaks[i];
    for (std::size_t k = 0; k < p.level.size(); ++k) {
      const std::string index = "[" + std::to_string(k) + "]";
      TestRun run{.state = p.state,
                  .base = static_cast<int>(p.base),
                  .level = p.level[k],
                  .sensor = p.sensor,
                  .axis = static_cast<int>(p.direction),
                  .peaks = {p.frequency[k]},
                  .first = true};
      const std::string of = std::string(" of the first peak in ") +
                             letters[std::size_t(run.axis)] + ", base " +
                             letters[std::size_t(run.base)] + at_level(run.level);
      Reading reading{.kind = ReadingKind::frequency,
                      .name = "frequency" + of,
                      .unit = "Hz",
                      .entry = entry("peaks", i) + ".frequency" + index,
                      .state = p.state,
                      .run = int(all_.runs.size()),
                      .sensor = p.sensor,
                      .axis = run.axis,
                      .value = p.frequency[k],
                      .sigma = relative(p.sigma, p.frequency[k], frequency_sigma),
                      .assumed = !p.sigma};
      add(reading);
      if (k < p.amplitude.size()) {
        reading.kind = ReadingKind::amplitude;
        reading.name = "amplitude" + of;
        reading.entry = entry("peaks", i) + ".amplitude" + index;
        reading.unit = "";
        reading.value = p.amplitude[k];
        reading.sigma = amplitude_sigma;
        add(reading);
      }
      if (k < p.damping.size()) {
        reading.name = "frequency" + of;
        reading.entry = entry("peaks", i) + ".damping" + index;
        add_damping(reading, p.damping[k], std::nullopt);
      }
      all_.runs.push_back(std::move(run));
    }
  }

  // Column of a channel of a set; -1 = not there.
  static Index column(const FrfSet& set, const std::string& sensor, int axis) {
    const std::string name = sensor + "." + letters[std::size_t(axis)];
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
        all_.warnings.push_back(entry("frf", i) +
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
      all_.warnings.push_back(entry("frf", i) + ": no peak along the axis of the base");
      return;
    }
    if (peaks.size() > most) peaks.resize(most);
    for (const FittedPeak& p : peaks) run.peaks.push_back(p.frequency);
    for (std::size_t k = 0; k < peaks.size(); ++k) add_main(i, set, run, int(k), peaks[k]);
    for (const std::string& sensor : sensors_of(set))
      add_others(i, set, H, run, sensor, peaks.front());
    sources_.push_back({i, &set, reference, all_.runs.size()});
    all_.runs.push_back(std::move(run));
  }

  // What shows along another axis where that axis resonates, over the height of the resonance when
  // the table moves along it.
  void cross_resonances() {
    for (const Source& own : sources_)
      for (const Source& other : sources_) {
        const TestRun &run = all_.runs[own.run], &at = all_.runs[other.run];
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
        reading.name = std::string("share in ") + letters[std::size_t(at.base)] +
                       " at its resonance, base " + letters[std::size_t(run.base)] +
                       at_level(run.level);
        reading.value = ratio;
        reading.log_value = std::log(ratio + cross_floor);
        reading.sigma = std::hypot(0.03, noise * ratio / (ratio + cross_floor));
        add(reading);
      }
  }

  // Along an axis that the table is never moved along in this state: the highest of the band.
  void highest_along_other_axes() {
    for (const Source& own : sources_) {
      const TestRun& run = all_.runs[own.run];
      for (int axis = 0; axis < 3; ++axis) {
        if (std::any_of(all_.runs.begin(), all_.runs.end(), [&](const TestRun& other) {
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
        reading.name = std::string("highest in ") + letters[std::size_t(axis)] + " over that in " +
                       letters[std::size_t(run.base)] + at_level(run.level);
        reading.value = ratio;
        reading.log_value = std::log(ratio + cross_floor);
        const double noise = stated_noise(own.entry, ratio * height);
        reading.sigma = std::hypot(0.03, noise * ratio / (ratio + cross_floor));
        add(reading);
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
            .entry = entry("frf", i),
            .state = run.state,
            .run = int(all_.runs.size()),
            .peak = peak,
            .sensor = run.sensor,
            .axis = run.axis};
  }

  void add_main(std::size_t i, const FrfSet& set, const TestRun& run, int k,
                const FittedPeak& peak) {
    const std::string of = " of peak " + std::to_string(k + 1) + " at " + run.sensor + " in " +
                           letters[std::size_t(run.axis)] + ", base " +
                           letters[std::size_t(run.base)] + at_level(run.level);
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
    add(reading);
    reading.kind = ReadingKind::damping;
    reading.name = "damping" + of;
    reading.unit = "";
    reading.value = peak.damping;
    reading.sigma = std::hypot(0.005, 2 * noise);
    add(reading);
    reading.kind = ReadingKind::amplitude;
    reading.name = "amplitude" + of;
    reading.value = peak.amplitude;
    reading.sigma = std::hypot(0.005, noise);
    add(reading);
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
    const std::string of =
        " at " + sensor + ", base " + letters[std::size_t(run.base)] + at_level(run.level);
    if (sensor != run.sensor) {
      reading.kind = ReadingKind::amplitude;
      reading.name = std::string("amplitude") + of;
      reading.value = height;
      reading.sigma = std::hypot(0.02, noise);
      add(reading);
    }
    for (int axis = 0; axis < 3; ++axis) {
      const Index c = axis == run.base ? -1 : column(set, sensor, axis);
      if (c < 0) continue;
      const double ratio = largest(c, cross_window) / height;
      reading.kind = ReadingKind::cross;
      reading.axis = axis;
      reading.name = std::string("share in ") + letters[std::size_t(axis)] + of;
      reading.value = std::max(ratio, 1e-9);
      reading.log_value = std::log(ratio + cross_floor);
      reading.sigma = std::hypot(0.03, std::hypot(noise, noise * 0.5 / (ratio + cross_floor)));
      add(reading);
    }
  }

  // Without a word on it, the highest of three levels or more in a direction is held out.
  void hold_out_by_level() {
    if (!measured_.hold_out.empty()) return;
    for (int base = 0; base < 3; ++base) {
      std::set<double> levels;
      for (const TestRun& run : all_.runs)
        if (run.base == base && run.level > 0) levels.insert(run.level);
      if (levels.size() < 3) continue;
      for (Reading& r : all_.readings)
        if (r.run >= 0 && all_.runs[std::size_t(r.run)].base == base &&
            all_.runs[std::size_t(r.run)].level == *levels.rbegin())
          r.held_out = true;
    }
  }

  struct Source { // of a run from a response
    std::size_t entry = 0;
    const FrfSet* set = nullptr;
    int reference = 0;
    std::size_t run = 0;
  };

  const DiagnosisData& test_;
  const Measured& measured_;
  TestReadings all_;
  std::vector<Source> sources_;
};

} // namespace

TestReadings readings_of(const DiagnosisData& test) {
  return Collector(test).collect();
}

} // namespace plica

#include "compare/compare.hpp"

#include "lab/measured/entries.hpp"
#include "lab/measured/measured_words.hpp"
#include "lab/measured/slope_at.hpp"
#include "lab/measured/states.hpp"
#include "model/description/connector_curve.hpp"
#include "words/units.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace plica {
namespace {

// Force over displacement at a stroke, or how it grows there, where the model has a curve for that
// direction; none otherwise.
std::optional<double> over_stroke_of(const Results& results, const MeasuredStatic& k) {
  if (!k.stroke) return std::nullopt;
  const bool across =
      k.direction == StaticDirection::transverse_x || k.direction == StaticDirection::transverse_z;
  if (!across && k.direction != StaticDirection::axial) return std::nullopt;
  for (const StrokeCurve& c : results.strokes)
    if (c.direction == (across ? StrokeCurve::across : StrokeCurve::along))
      return k.slope == StaticSlope::secant
                 ? force_at(c.points, *k.stroke) / *k.stroke
                 : slope_at([&](double x) { return force_at(c.points, x); }, *k.stroke);
  return std::nullopt;
}

// Response to motion of the base along an axis; null when there is none.
const ResponseResult* response_to(const Results& results, Axis base) {
  for (const ResponseResult& r : results.responses)
    if (r.source == Source::base && r.excitation == word_of(base)) return &r;
  return nullptr;
}

bool in_direction(const ResponseResult& r, int channel, Axis direction) {
  return r.channels[channel].second == word_of(direction);
}

// The `count` largest peaks of the channels in a direction, of one sensor if it is named, by
// frequency; one per frequency.
std::vector<ResponsePeak> largest_peaks(const ResponseResult& r, Axis direction,
                                        const std::string& sensor, std::size_t count) {
  std::vector<ResponsePeak> peaks;
  for (const ResponsePeak& p : r.peaks)
    if (in_direction(r, p.channel, direction) &&
        (sensor.empty() || r.channels[p.channel].first == sensor))
      peaks.push_back(p);
  std::stable_sort(peaks.begin(), peaks.end(), [](const ResponsePeak& a, const ResponsePeak& b) {
    return a.amplitude > b.amplitude;
  });
  std::vector<ResponsePeak> kept;
  for (const ResponsePeak& p : peaks)
    if (kept.size() < count && std::none_of(kept.begin(), kept.end(), [&](const ResponsePeak& k) {
          return std::abs(k.frequency - p.frequency) < 0.01 * p.frequency; // seen by two sensors
        }))
      kept.push_back(p);
  std::sort(kept.begin(), kept.end(),
            [](const ResponsePeak& a, const ResponsePeak& b) { return a.frequency < b.frequency; });
  return kept;
}

void add_peak(std::vector<MeasuredComparison>& rows, const MeasuredMode& m, const std::string& from,
              const ResponsePeak& peak) {
  std::string of = " of the peak";
  if (!m.sensor.empty()) of += " at " + m.sensor + " in " + word_of(m.direction.value_or(*m.base));
  of += std::string(", base ") + word_of(*m.base);
  rows.push_back({.quantity = "frequency" + of,
                  .unit = "Hz",
                  .measured = m.frequency,
                  .sigma = m.sigma.value_or(0),
                  .computed = peak.frequency,
                  .entry = from,
                  .of_peak = true});
  if (m.damping && std::isfinite(peak.damping))
    rows.push_back({.quantity = "half-power damping" + of,
                    .unit = "%",
                    .measured = 100 * *m.damping,
                    .sigma = 100 * m.sigma_damping.value_or(0),
                    .computed = 100 * peak.damping,
                    .entry = from,
                    .kind = ComparedKind::damping,
                    .of_peak = true});
}

void add_weighings(std::vector<MeasuredComparison>& rows, const Results& results,
                   const Measured& measured) {
  for (std::size_t i = 0; i < measured.weighings.size(); ++i) {
    const MeasuredMass& w = measured.weighings[i];
    if (as_drawn(measured, w.state))
      rows.push_back({.quantity = "mass",
                      .unit = "kg",
                      .measured = w.value,
                      .sigma = w.sigma.value_or(0),
                      .computed = results.model.mass,
                      .entry = weighing_name(measured, i),
                      .kind = ComparedKind::mass});
  }
}

// First peaks of the measured levels at which the model was excited too.
void add_level_peaks(std::vector<MeasuredComparison>& rows, const Results& results,
                     const MeasuredPeaks& measured, const std::string& from) {
  for (const LevelResponses& responses : results.level_responses) {
    if (responses.is_force || responses.excitation != word_of(measured.base)) continue;
    for (std::size_t k = 0; k < measured.level.size(); ++k)
      for (const LevelCurve& curve : responses.curves) {
        if (std::abs(curve.level - measured.level[k]) > 1e-6 * curve.level) continue;
        const auto peak =
            std::find_if(curve.peaks_up.begin(), curve.peaks_up.end(), [&](const LevelPeak& p) {
              const auto& [sensor, axis] = responses.channels[std::size_t(p.channel)];
              return sensor == measured.sensor && axis == word_of(measured.direction);
            });
        if (peak == curve.peaks_up.end()) continue;
        const std::string of =
            fmt::format(" of the first peak at {} in {}, base {}, {:g} m/s2", measured.sensor,
                        word_of(measured.direction), word_of(measured.base), curve.level);
        rows.push_back({.quantity = std::string("frequency") + of,
                        .unit = "Hz",
                        .measured = measured.frequency[k],
                        .sigma = measured.sigma.value_or(0),
                        .computed = peak->frequency,
                        .entry = from + ".frequency[" + std::to_string(k) + "]",
                        .level = measured.level[k]});
        if (k < measured.amplitude.size())
          rows.push_back({.quantity = std::string("amplitude") + of,
                          .unit = "",
                          .measured = measured.amplitude[k],
                          .computed = peak->amplitude,
                          .entry = from + ".amplitude[" + std::to_string(k) + "]",
                          .kind = ComparedKind::amplitude,
                          .level = measured.level[k]});
        if (k < measured.damping.size())
          rows.push_back({.quantity = std::string("damping by energy") + of,
                          .unit = "%",
                          .measured = 100 * measured.damping[k],
                          .computed = 100 * peak->energy_damping,
                          .entry = from + ".damping[" + std::to_string(k) + "]",
                          .kind = ComparedKind::damping,
                          .level = measured.level[k]});
      }
  }
}

// Peaks of one sensor and direction in order: the i-th measured with the i-th of as many largest
// computed ones. Without a sensor the order of the mode says which peak it is.
struct PeakPlace {
  std::size_t rank = 0, count = 0; // from 1
};

PeakPlace place_of(const MeasuredMode& mode, const std::vector<MeasuredMode>& all) {
  if (mode.sensor.empty()) return {std::size_t(mode.order), std::size_t(mode.order)};
  PeakPlace place;
  for (const MeasuredMode& other : all) {
    if (other.sensor != mode.sensor || other.base != mode.base || other.state != mode.state ||
        other.direction.value_or(*other.base) != mode.direction.value_or(*mode.base))
      continue;
    ++place.count;
    if (other.frequency <= mode.frequency) ++place.rank;
  }
  return place;
}

} // namespace

std::vector<std::string> unanswered(const Results& results, const Measured& measured) {
  std::vector<std::string> remarks;
  if (std::any_of(measured.peaks.begin(), measured.peaks.end(),
                  [&](const MeasuredPeaks& p) { return as_drawn(measured, p.state); }) &&
      results.level_responses.empty())
    remarks.emplace_back("the peaks over the level of the test stand beside nothing: the case asks "
                         "for no `levels`. A frequency of a single sweep goes to `modes`; `plica "
                         "diagnose` reads both.");
  if (std::any_of(measured.stiffness.begin(), measured.stiffness.end(),
                  [&](const MeasuredStiffnessTable& s) { return as_drawn(measured, s.state); }))
    remarks.emplace_back("the dynamic stiffness of the test stands beside nothing: a run computes "
                         "none. `plica stiffness --measured TABLE` compares it, `plica fit` fits "
                         "to it.");
  for (const MeasuredMode& m : measured.modes) {
    if (!m.base || !m.direction || *m.base == *m.direction || !as_drawn(measured, m.state))
      continue;
    const ResponseResult* response = response_to(results, *m.base);
    if (!response || m.frequency < response->hertz[0] ||
        m.frequency > response->hertz[response->hertz.size() - 1])
      continue;
    double cross = 0, largest = 0;
    for (std::size_t c = 0; c < response->channels.size(); ++c) {
      const double high = response->acceleration.col(Eigen::Index(c)).cwiseAbs().maxCoeff();
      largest = std::max(largest, high);
      if (in_direction(*response, static_cast<int>(c), *m.direction)) cross = std::max(cross, high);
    }
    if (cross > 1e-3 * largest) continue;
    remarks.push_back(fmt::format(
        "the test saw {:.0f} Hz in {} while the base moved in {}; the model answers in {} "
        "with {:.1g} of its largest channel. It has no path from one to the other: only what "
        "breaks its symmetry (a dent, a sensor's mass, a flexible fixture, a base that "
        "also moves in {}) can make one.",
        m.frequency, word_of(*m.direction), word_of(*m.base), word_of(*m.direction),
        largest > 0 ? cross / largest : 0, word_of(*m.direction)));
  }
  return remarks;
}

std::vector<MeasuredComparison> compare(const Results& results, const Measured& measured) {
  std::vector<MeasuredComparison> rows;
  add_weighings(rows, results, measured);
  for (std::size_t i = 0; i < measured.statics.size(); ++i) {
    const MeasuredStatic& k = measured.statics[i];
    if (!results.statics) break;
    if (!as_drawn(measured, k.state)) continue;
    const std::optional<double> over_stroke = over_stroke_of(results, k);
    std::string name = stiffness_name(k.direction);
    if (over_stroke)
      name += (k.slope == StaticSlope::secant ? " over " : " at ") + millimetres(*k.stroke);
    rows.push_back(
        {.quantity = name,
         .unit = stiffness_unit(k.direction),
         .measured = k.value,
         .sigma = k.sigma.value_or(0),
         .computed = over_stroke.value_or(results.statics->all()[std::size_t(k.direction)]),
         .entry = entry_name("static", i),
         .kind = ComparedKind::stiffness,
         .static_test = int(k.direction),
         .over_stroke = over_stroke.has_value()});
  }
  for (std::size_t i = 0; i < measured.modes.size(); ++i) {
    const MeasuredMode& m = measured.modes[i];
    if (!as_drawn(measured, m.state)) continue;
    std::map<std::string, int> order; // of the shape in each direction: a pair counts once
    for (const ModeResult& mode : results.modes) {
      const bool same = mode.shape == word_of(m.shape) &&
                        (!m.direction || mode.direction == word_of(*m.direction));
      if (!same || ++order[mode.direction] < m.order) continue;
      rows.push_back(
          {.quantity = std::string(word_of(m.shape)) + " mode " + std::to_string(m.order),
           .unit = "Hz",
           .measured = m.frequency,
           .sigma = m.sigma.value_or(0),
           .computed = mode.frequency,
           .entry = entry_name("modes", i)});
      break;
    }
  }
  for (std::size_t i = 0; i < measured.modes.size(); ++i) {
    const MeasuredMode& m = measured.modes[i];
    const ResponseResult* response = m.base ? response_to(results, *m.base) : nullptr;
    if (!response || !as_drawn(measured, m.state)) continue;
    const PeakPlace place = place_of(m, measured.modes);
    const auto peaks =
        largest_peaks(*response, m.direction.value_or(*m.base), m.sensor, place.count);
    if (peaks.size() == place.count)
      add_peak(rows, m, entry_name("modes", i), peaks[place.rank - 1]);
  }
  for (std::size_t i = 0; i < measured.peaks.size(); ++i)
    if (as_drawn(measured, measured.peaks[i].state))
      add_level_peaks(rows, results, measured.peaks[i], entry_name("peaks", i));
  return rows;
}

void add_test_curves(Results& results, const TestData& test) {
  for (ResponseResult& r : results.responses) {
    if (r.source != Source::base) continue;
    const auto distance = [&](const FrfSet& set) {
      return set.level && r.level > 0 ? std::abs(std::log(*set.level / r.level)) : 0;
    };
    double nearest = std::numeric_limits<double>::infinity();
    for (const FrfSet* one : all_responses(test)) {
      const FrfSet& set = *one;
      const auto found =
          std::find(set.references.begin(), set.references.end(), "base." + r.excitation);
      if (set.quantity != FrfQuantity::transmissibility || found == set.references.end()) continue;
      if (distance(set) > nearest + 1e-9) continue;
      if (distance(set) < nearest - 1e-9) r.test.clear();
      nearest = distance(set);
      const Eigen::MatrixXcd& H = set.H[std::size_t(found - set.references.begin())];
      for (std::size_t k = 0; k < set.responses.size(); ++k)
        for (std::size_t c = 0; c < r.channels.size(); ++c)
          if (set.responses[k] == r.channels[c].first + "." + r.channels[c].second) {
            const Eigen::VectorXcd own = H.col(Eigen::Index(k));
            r.test.push_back({.channel = int(c),
                              .hertz = set.hertz,
                              .magnitude = own.cwiseAbs(),
                              .phase = {},
                              .level = set.level});
            if (!own.imag().isZero(0)) r.test.back().phase = own.cwiseArg();
          }
    }
  }
}

} // namespace plica

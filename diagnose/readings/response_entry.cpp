#include "diagnose/readings/response_entry.hpp"

#include "lab/measured/measured_words.hpp"
#include "words/directions.hpp"

#include <algorithm>
#include <cmath>

namespace plica {

using Eigen::Index;

Input ResponseEntry::input() const {
  const std::string& reference_name = set->references[std::size_t(reference)];
  if (reference_name.starts_with("base."))
    return {.base = axis_of_channel(reference_name), .force = ""};
  return {.force = reference_name};
}

Index ResponseEntry::column(const std::string& sensor, int axis) const {
  const std::string name = sensor + "." + axis_word(axis);
  const auto found = std::find(set->responses.begin(), set->responses.end(), name);
  return found == set->responses.end() ? -1 : found - set->responses.begin();
}

std::vector<std::string> ResponseEntry::sensors() const {
  std::vector<std::string> names;
  for (const std::string& channel : set->responses)
    if (const std::string name(sensor_of_channel(channel));
        std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  return names;
}

Eigen::VectorXcd ResponseEntry::response(Index column) const {
  return acceleration_of(*set, reference, column);
}

bool ResponseEntry::covers(double hertz, double distance) const {
  return set->hertz.minCoeff() <= hertz * (1 - distance) &&
         set->hertz.maxCoeff() >= hertz * (1 + distance);
}

double ResponseEntry::largest(Index column, double hertz, double distance) const {
  const Eigen::VectorXcd H = response(column);
  double value = 0;
  for (Index k = 0; k < set->hertz.size(); ++k)
    if (std::abs(set->hertz[k] / hertz - 1) <= distance) value = std::max(value, std::abs(H[k]));
  return value;
}

double ResponseEntry::height_at(Index column, const FittedPeak& peak) const {
  return plica::height_at(peak, set->hertz, response(column));
}

double ResponseEntry::stated_noise(double amplitude) const {
  const auto& sigma = stated->sigma;
  return sigma ? std::hypot(sigma->relative, sigma->floor / amplitude) : 0;
}

TestRun ResponseEntry::run() const {
  return {.state = stated->state,
          .input = input(),
          .level = stated->level.value_or(0),
          .by_force = !input().force.empty(),
          .sensor = "",
          .axis = std::max(0, input().base),
          .peaks = {},
          .band = {set->hertz[0], set->hertz[set->hertz.size() - 1]}};
}

Reading ResponseEntry::blank(const TestRun& run, int run_number, int peak) const {
  return {.name = "",
          .unit = "",
          .entry = entry_name("frf", number),
          .state = run.state,
          .run = run_number,
          .peak = peak,
          .sensor = run.sensor,
          .axis = run.axis};
}

void add_peak(const ResponseEntry& entry, const TestRun& run, int number, int k,
              const FittedPeak& peak, ReadingList& list) {
  const std::string of = " of peak " + std::to_string(k + 1) + " " + where_seen(run);
  const Eigen::VectorXd& hertz = entry.set->hertz;
  const double step = (hertz[hertz.size() - 1] - hertz[0]) /
                      double(std::max<Index>(1, hertz.size() - 1)) / peak.frequency;
  // Of what a fit finds from so many lines: relative to height, half of it to width.
  const double noise = std::max(peak.noise, entry.stated_noise(peak.amplitude)) /
                       std::sqrt(std::max(1., peak.lines / 4.));
  Reading reading = entry.blank(run, number, k);
  reading.kind = ReadingKind::frequency;
  reading.name = "frequency" + of;
  reading.unit = "Hz";
  reading.value = peak.frequency;
  reading.sigma = std::max(peak.damping * noise, 0.05 * step);
  list.add(reading);
  reading.kind = ReadingKind::damping;
  reading.name = "damping" + of;
  reading.unit = "";
  reading.value = peak.damping;
  reading.sigma = std::hypot(0.005, 2 * noise);
  list.add(reading);
  reading.kind = ReadingKind::amplitude;
  reading.name = "amplitude" + of;
  reading.unit = run.by_force ? "m/s2/N" : "";
  reading.value = peak.amplitude;
  reading.sigma = std::hypot(0.005, noise);
  list.add(reading);
}

double highest_of(const std::vector<FittedPeak>& peaks) {
  double value = 0;
  for (const FittedPeak& p : peaks) value = std::max(value, p.amplitude);
  return value;
}

} // namespace plica

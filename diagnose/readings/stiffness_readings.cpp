#include "diagnose/readings/stiffness_readings.hpp"

#include "words/directions.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

namespace plica {
namespace {

constexpr double stiffness_sigma = 0.03; // of a table that states none
constexpr double frequency_error = 0.003;
constexpr double least_loss = 2; // in terms of its standard deviation
constexpr std::size_t most_frequencies = 6, frequencies_with_amplitudes = 3, most_amplitudes = 4;

// What a table says of one motion at one frequency.
struct Point {
  std::optional<double> storage, loss, magnitude, angle;

  double size() const { // |k|, or the storage alone; 0 = not given
    if (magnitude) return *magnitude;
    if (storage && loss) return std::hypot(*storage, *loss);
    if (storage && angle) return std::abs(*storage / std::cos(*angle));
    return storage ? std::abs(*storage) : 0;
  }
  bool is_storage() const { return !magnitude && !loss && !angle; }
  double loss_factor() const { // 0 = not given
    if (angle) return std::abs(std::sin(*angle));
    return loss && size() > 0 ? std::abs(*loss) / size() : 0;
  }
};

struct RigMotion {
  int direction = 0;
  StiffnessKind kind = StiffnessKind::transfer;
  double amplitude = 0;
  auto operator<=>(const RigMotion&) const = default;
};
using Curve = std::map<double, Point>; // by the frequency

std::map<RigMotion, Curve> curves_of(const std::vector<MeasuredStiffness>& numbers) {
  std::map<RigMotion, Curve> curves;
  for (const MeasuredStiffness& m : numbers) {
    Point& p = curves[{m.direction, m.kind, m.amplitude}][m.hertz];
    switch (m.quantity) {
    case StiffnessQuantity::storage:
      p.storage = m.value;
      break;
    case StiffnessQuantity::loss:
      p.loss = m.value;
      break;
    case StiffnessQuantity::magnitude:
      p.magnitude = std::abs(m.value);
      break;
    case StiffnessQuantity::loss_angle:
      p.angle = m.value;
      break;
    }
  }
  return curves;
}

// Evenly among them, the first and the last with them.
std::vector<double> spread(const std::vector<double>& sorted, std::size_t most) {
  if (sorted.size() <= most) return sorted;
  std::vector<double> chosen;
  for (std::size_t k = 0; k < most; ++k)
    chosen.push_back(sorted[(k * (sorted.size() - 1) + (most - 1) / 2) / (most - 1)]);
  return chosen;
}

template <class Numbers> std::vector<double> without_repeats(Numbers all) {
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

// |d ln |k| / d ln f| between the neighbours of a frequency.
double slope_at(const Curve& curve, Curve::const_iterator at) {
  const auto low = at == curve.begin() ? at : std::prev(at);
  auto high = std::next(at);
  if (high == curve.end()) high = at;
  const double a = low->second.size(), b = high->second.size();
  if (low == high || !(low->first > 0) || !(a > 0) || !(b > 0)) return 0;
  return std::abs(std::log(b / a) / std::log(high->first / low->first));
}

std::string words_of(const RigMotion& m) {
  std::string words = direction_names[std::size_t(m.direction)];
  if (m.kind == StiffnessKind::driving_point) words += " driving point";
  return words;
}

std::string conditions_of(const RigMotion& m, double hertz) {
  if (!(m.amplitude > 0)) return fmt::format(", {:g} Hz", hertz);
  const bool length = m.direction < 3;
  return fmt::format(" at {:g} {}, {:g} Hz", m.amplitude * (length ? 1e3 : 180 / std::numbers::pi),
                     length ? "mm" : "deg", hertz);
}

void add_point(const Reading& blank, const RigMotion& motion, const Curve& curve,
               Curve::const_iterator at, double sigma, ReadingList& list) {
  const Point& p = at->second;
  Reading r = blank;
  r.rig.hertz = at->first;
  const std::string of = words_of(motion), at_what = conditions_of(motion, at->first);
  r.kind = ReadingKind::dynamic_stiffness;
  r.rig.storage = p.is_storage();
  r.name = of + (r.rig.storage ? " storage" : " stiffness") + at_what;
  r.unit = motion.direction < 3 ? "N/m" : "Nm/rad";
  r.value = p.size();
  r.sigma = std::hypot(sigma, frequency_error * slope_at(curve, at));
  list.add(r);
  const double loss = p.loss_factor();
  if (!(loss > least_loss * sigma)) return;
  r.kind = ReadingKind::loss;
  r.rig.storage = false;
  r.name = of + " loss factor" + at_what;
  r.unit = "";
  r.value = loss;
  r.sigma = sigma / loss;
  list.add(r);
}

void add_table(const MeasuredStiffnessTable& table, const std::string& entry, ReadingList& list) {
  const std::map<RigMotion, Curve> curves = curves_of(table.numbers);
  std::vector<double> hertz, lengths, angles;
  for (const auto& [motion, curve] : curves) {
    (motion.direction < 3 ? lengths : angles).push_back(motion.amplitude);
    for (const auto& [f, point] : curve) hertz.push_back(f);
  }
  lengths = without_repeats(lengths);
  angles = without_repeats(angles);
  const bool levels = std::max(lengths.size(), angles.size()) > 1;
  hertz = spread(without_repeats(hertz), levels ? frequencies_with_amplitudes : most_frequencies);
  const auto holds = [](const std::vector<double>& all, double x) {
    return std::find(all.begin(), all.end(), x) != all.end();
  };
  lengths = spread(lengths, most_amplitudes);
  angles = spread(angles, most_amplitudes);
  for (const auto& [motion, curve] : curves) {
    if (!holds(motion.direction < 3 ? lengths : angles, motion.amplitude)) continue;
    Reading blank{.name = "", .unit = "", .entry = entry, .state = table.state, .sensor = ""};
    blank.axis = motion.direction;
    blank.stroke = motion.amplitude;
    blank.rig.ends = table.ends;
    blank.rig.driving_point = motion.kind == StiffnessKind::driving_point;
    blank.assumed = !table.sigma;
    for (auto at = curve.begin(); at != curve.end(); ++at)
      if (holds(hertz, at->first))
        add_point(blank, motion, curve, at, table.sigma.value_or(stiffness_sigma), list);
  }
}

} // namespace

void add_stiffness_readings(const Measured& measured, ReadingList& list) {
  for (std::size_t i = 0; i < measured.stiffness.size(); ++i) {
    const std::size_t before = list.all.readings.size();
    add_table(measured.stiffness[i], entry_name("stiffness", i), list);
    if (list.all.readings.size() == before)
      list.all.warnings.push_back(entry_name("stiffness", i) +
                                  ": neither storage nor magnitude nor loss angle above its error: "
                                  "a loss alone is not read");
  }
}

} // namespace plica

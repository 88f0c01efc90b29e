#include "diagnose/effects/effect.hpp"

#include <set>

namespace plica {
namespace {

constexpr std::array axis_letters{"x", "y", "z"};

std::set<Axis> bases(const Measured& measured) {
  std::set<Axis> axes;
  for (const MeasuredMode& m : measured.modes)
    if (m.base) axes.insert(*m.base);
  for (const MeasuredPeaks& p : measured.peaks) axes.insert(p.base);
  for (const MeasuredFrf& f : measured.frf)
    if (f.base) axes.insert(*f.base);
  return axes;
}

std::vector<Hypothesis> hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  for (Axis base : bases(s.measured))
    for (int other = 0; other < 3; ++other) {
      const int told = static_cast<int>(base);
      if (other == told) continue;
      found.push_back({.effect = "cross_axis_base_motion",
                       .place = "base",
                       .way = std::string(axis_letters[std::size_t(told)]) + " to " +
                              axis_letters[std::size_t(other)],
                       .parameters = {{"fraction", "", {PriorKind::normal, 0, 0.06}}},
                       .setup = [told, other](TestSetup& setup, const Eigen::VectorXd& v) {
                         setup.base(other, told) += v[0];
                       }});
    }
  return found;
}

} // namespace

Effect cross_axis_base_motion() {
  return {.name = "cross_axis_base_motion",
          .physics = "the table also moves along another axis than it was told",
          .signature = "cross responses that follow the other axis",
          .look_alikes = {"local_damage: an accelerometer on the table",
                          "rotated_sensor: turn the sensor"},
          .hypotheses = hypotheses};
}

} // namespace plica

#include "diagnose/effects/effect.hpp"

#include "words/directions.hpp"

#include <set>

namespace plica {
namespace {

std::set<Axis> bases(const Measured& measured) {
  std::set<Axis> axes;
  for (const MeasuredMode& m : measured.modes)
    if (m.base) axes.insert(*m.base);
  for (const MeasuredPeaks& p : measured.peaks) axes.insert(p.base);
  for (const MeasuredFrf& f : measured.frf)
    if (f.base) axes.insert(*f.base);
  return axes;
}

Hypothesis coupling(const std::string& way, std::function<void(Eigen::Matrix3d&, double)> couple) {
  return {.effect = "cross_axis_base_motion",
          .place = "base",
          .way = way,
          .parameters = {{"fraction", "", {PriorKind::normal, 0, 0.06}}},
          .setup = [couple = std::move(couple)](TestSetup& setup, const Eigen::VectorXd& v) {
            couple(setup.base, v[0]);
          }};
}

// One commanded axis into another; two into each other alike; and the specimen turned on the table.
std::vector<Hypothesis> cross_axis_base_motion_hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  const std::set<Axis> told = bases(s.measured);
  const auto name = [](int axis) { return std::string(axis_word(axis)); };
  for (Axis base : told)
    for (int b = 0; b < 3; ++b)
      if (const int a = static_cast<int>(base); a != b)
        found.push_back(coupling(name(a) + " to " + name(b),
                                 [a, b](Eigen::Matrix3d& m, double f) { m(b, a) += f; }));
  for (Axis first : told)
    for (Axis second : told) {
      const int a = static_cast<int>(first), b = static_cast<int>(second);
      if (a >= b) continue;
      found.push_back(
          coupling(name(a) + " and " + name(b) + " alike", [a, b](Eigen::Matrix3d& m, double f) {
            m(b, a) += f;
            m(a, b) += f;
          }));
      found.push_back(
          coupling(name(a) + " turned to " + name(b), [a, b](Eigen::Matrix3d& m, double f) {
            m(b, a) += f;
            m(a, b) -= f;
          }));
    }
  return found;
}

} // namespace

Effect cross_axis_base_motion() {
  return {.name = "cross_axis_base_motion",
          .plain = "a table that also moves along another axis, by {fraction%} of its motion",
          .physics = "the table also moves along another axis than it was told",
          .signature = "cross responses that follow the other axis",
          .look_alikes = {{"local_damage", "an accelerometer on the table"},
                          {"rotated_sensor", "turn the sensor"}},
          .needs = "a run of the table",
          .hypotheses = cross_axis_base_motion_hypotheses};
}

} // namespace plica

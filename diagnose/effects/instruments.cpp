#include "diagnose/effects/effect.hpp"

#include <Eigen/Geometry>
#include <set>

namespace plica {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::array axis_letters{"x", "y", "z"};

Matrix3d& reading_of(TestSetup& setup, const std::string& sensor) {
  return setup.reading.try_emplace(sensor, Matrix3d::Identity()).first->second;
}

std::set<Axis> bases(const Measured& measured) {
  std::set<Axis> axes;
  for (const MeasuredMode& m : measured.modes)
    if (m.base) axes.insert(*m.base);
  for (const MeasuredPeaks& p : measured.peaks) axes.insert(p.base);
  for (const MeasuredFrf& f : measured.frf)
    if (f.base) axes.insert(*f.base);
  return axes;
}

} // namespace

std::vector<Hypothesis> rotated_sensor(const Structure& s) {
  std::vector<Hypothesis> found;
  for (const BuiltSensor& sensor : s.built.sensors)
    for (int axis = 0; axis < 3; ++axis)
      found.push_back(
          {.effect = "rotated_sensor",
           .place = "sensor." + sensor.name,
           .way = std::string("about ") + axis_letters[std::size_t(axis)],
           .parameters = {{"angle", "rad", {PriorKind::normal, 0, 0.15}}},
           .setup = [name = sensor.name, axis](TestSetup& setup, const Eigen::VectorXd& v) {
             Matrix3d& reading = reading_of(setup, name);
             reading = Eigen::AngleAxisd(-v[0], Vector3d::Unit(axis)).toRotationMatrix() * reading;
           }});
  return found;
}

std::vector<Hypothesis> sensor_gain(const Structure& s) {
  std::vector<Hypothesis> found;
  for (const BuiltSensor& sensor : s.built.sensors)
    found.push_back({.effect = "sensor_gain",
                     .place = "sensor." + sensor.name,
                     .way = "",
                     .parameters = {{"gain", "", {PriorKind::log_normal, 1, 0.15}}},
                     .setup = [name = sensor.name](TestSetup& setup, const Eigen::VectorXd& v) {
                       reading_of(setup, name) *= v[0];
                     }});
  return found;
}

std::vector<Hypothesis> cross_axis_base_motion(const Structure& s) {
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

} // namespace plica

#include "diagnose/effects/places.hpp"

#include "model/description/place_keys.hpp"
#include "words/directions.hpp"

#include <Eigen/Geometry>

namespace plica {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<Hypothesis> rotated_sensor_hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  for (const std::string& sensor : sensor_names(s))
    for (int axis = 0; axis < 3; ++axis)
      found.push_back(
          {.effect = "rotated_sensor",
           .place = sensor_place(sensor),
           .way = std::string("about ") + axis_word(axis),
           .parameters = {{"angle", "rad", {PriorKind::normal, 0, 0.25}}},
           .setup = [name = sensor, axis](TestSetup& setup, const Eigen::VectorXd& v) {
             Matrix3d& reading = setup.reading_of(name);
             reading = Eigen::AngleAxisd(-v[0], Vector3d::Unit(axis)).toRotationMatrix() * reading;
           }});
  return found;
}

} // namespace

Effect rotated_sensor() {
  return {.name = "rotated_sensor",
          .plain = "a sensor that is turned by {angle}",
          .physics = "a sensor is turned about one of its axes",
          .signature = "its cross channels show the main motion, those of other sensors do not",
          .look_alikes = {{"local_damage", "turn the sensor, look at a second one"},
                          {"cross_axis_base_motion", "an accelerometer on the table"}},
          .needs = "a sensor",
          .hypotheses = rotated_sensor_hypotheses};
}

} // namespace plica

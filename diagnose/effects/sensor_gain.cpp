#include "diagnose/effects/places.hpp"
#include "model/description/place_keys.hpp"

namespace plica {
namespace {

std::vector<Hypothesis> sensor_gain_hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  for (const std::string& sensor : sensor_names(s))
    found.push_back({.effect = "sensor_gain",
                     .place = sensor_place(sensor),
                     .way = "",
                     .parameters = {{"gain", "", {PriorKind::log_normal, 1, 0.15}}},
                     .setup = [name = sensor](TestSetup& setup, const Eigen::VectorXd& v) {
                       setup.reading_of(name) *= v[0];
                     }});
  return found;
}

} // namespace

Effect sensor_gain() {
  return {
      .name = "sensor_gain",
      .plain = "a sensor whose reading is {gain+} off",
      .physics = "a sensor reads too much or too little",
      .signature = "all its amplitudes, no frequency, no width of a peak",
      .look_alikes = {{"damping", "the width of the peaks"}, {"added_mass", "exchange the sensor"}},
      .needs = "a sensor",
      .hypotheses = sensor_gain_hypotheses};
}

} // namespace plica

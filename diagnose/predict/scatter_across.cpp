// What the errors of any test add along other axes: a sensor is turned, a table moves across.
#include "diagnose/predict/state_answers.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace plica {

using Eigen::Vector2d;

// Mean squares, in terms of the main motion: per radian about each axis of the sensor, and per unit
// across of one along. At the resonance, where what is across is largest.
Vector2d StateAnswers::scatter_across(const Reading& reading) {
  const TestRun& run = test_.runs[std::size_t(reading.run)];
  const int number = reading.at_run >= 0 ? reading.at_run : reading.run;
  const int sensor = own_.nominal->number_of(reading.sensor);
  if (sensor < 0 || !run.input.any() || !answers_to(run) || !predict_peaks(number))
    return Vector2d::Zero();
  const Peak& peak =
      peaks_.at(number)[reading.at_run >= 0 ? 0 : std::size_t(std::max(0, reading.peak))];
  if (peak.mode < 0) return Vector2d::Zero();
  const bool by_table = run.input.base >= 0;
  const int over = by_table || reading.at_run >= 0 ? sensor : own_.nominal->number_of(run.sensor);
  if (over < 0) return Vector2d::Zero();
  const int along = reading.at_run >= 0 ? reading.axis : by_table ? run.input.base : run.axis;
  const double main = summit(peak, over, along).second;
  const auto seen = [&](const TestRun& driven, int axis) {
    const Eigen::MatrixXcd moved = motion(*peak.modes, peak.zeta, driven, {peak.omega()});
    return std::abs(reading_of(moved, sensor, axis)(0)) / main;
  };
  Vector2d added = Vector2d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != reading.axis) added[0] += std::pow(seen(run, axis), 2);
    if (!by_table || axis == run.input.base) continue;
    TestRun other = run;
    other.input.base = axis;
    added[1] += std::pow(seen(other, reading.axis), 2);
  }
  return added;
}

} // namespace plica

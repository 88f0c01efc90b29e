#include "diagnose/predict/sensor_axes.hpp"

#include "words/directions.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace plica {

Eigen::Matrix3d axes_of(const BuiltSensor& sensor, const Measured& measured) {
  std::array<int, 3> axes = sensor.axes;
  for (const MeasuredSensor& m : measured.sensors)
    if (m.name == sensor.name && m.axes.size() == 3) std::copy_n(m.axes.begin(), 3, axes.begin());
  Eigen::Matrix3d rows = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i)
    rows(i, axis_of_signed(axes[std::size_t(i)])) = sign_of(axes[std::size_t(i)]);
  return rows;
}

Eigen::RowVectorXcd seen_along(const Eigen::Matrix3d& axes, const Eigen::Matrix3d* turned, int axis,
                               const Eigen::MatrixXcd& motion) {
  Eigen::RowVector3d direction = axes.row(axis);
  if (turned) direction = turned->row(axis) * axes;
  return direction.cast<std::complex<double>>() * motion;
}

} // namespace plica

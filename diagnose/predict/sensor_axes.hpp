// How a sensor sits: its own axes, and what it reads along one of them, turned or not.
#pragma once

#include "lab/measured/measured.hpp"
#include "model/shape/built_case.hpp"

#include <Eigen/Core>

namespace plica {

// Rows: its own axes, as the test says, else as the case does.
Eigen::Matrix3d axes_of(const BuiltSensor& sensor, const Measured& measured);

// The channel `axis` of a sensor with these axes, of its motion (3 x excitations) along x, y, z.
// `turned`: a rotation of the sensor that a hypothesis supposes; null for none.
Eigen::RowVectorXcd seen_along(const Eigen::Matrix3d& axes, const Eigen::Matrix3d* turned, int axis,
                               const Eigen::MatrixXcd& motion);

} // namespace plica

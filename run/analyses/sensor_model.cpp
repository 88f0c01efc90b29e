#include "run/analyses/sensor_model.hpp"

#include "words/directions.hpp"

#include <cmath>
#include <numbers>

namespace plica {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double frequency_of(const DampedModes& modes, int mode) {
  if (modes.complex.empty()) return frequency(modes.solution.lambda[mode]);
  return std::abs(modes.complex[std::size_t(mode)].s) / (2 * std::numbers::pi);
}

double damping_of(const DampedModes& modes, int mode) {
  if (modes.complex.empty())
    return modes.zeta[mode] + modes.eta[mode] / 2 +
           (modes.first_order.size() > 0 ? modes.first_order[mode] : 0);
  const std::complex<double> s = modes.complex[std::size_t(mode)].s;
  return -s.real() / std::abs(s);
}

ModalModel modal_model(const DampedModes& modes, MatrixXd output) {
  return {.lambda = modes.solution.lambda,
          .zeta = modes.zeta,
          .eta = modes.eta,
          .output = std::move(output),
          .input = modes.solution.input};
}

ModalResponse::ModalResponse(const DampedModes& modes, MatrixXd output)
    : modal_(modal_model(modes, std::move(output))) {
  if (!modes.dissipation.empty()) dissipative_.emplace(modal_, modes.dissipation);
}

MatrixXcd ModalResponse::operator()(const ExcitedColumns& excited, const VectorXd& hertz) const {
  const VectorXd omega = 2 * std::numbers::pi * hertz;
  if (dissipative_) {
    std::vector<std::pair<int, std::complex<double>>> loads;
    for (const auto& [column, factor] : excited) loads.emplace_back(column, factor);
    return (*dissipative_)(loads, omega);
  }
  MatrixXcd motion = frequency_response(modal_, excited.front().column, omega);
  if (excited.front().factor != 1.) motion *= excited.front().factor;
  for (std::size_t k = 1; k < excited.size(); ++k)
    motion += excited[k].factor * frequency_response(modal_, excited[k].column, omega);
  return motion;
}

SensorModel sensor_model(const BuiltCase& built, const DampedModes& modes,
                         const Excitations& excited) {
  SensorModel model{.relative = ModalResponse(modes, at_sensors(built, modes.solution.u)),
                    .rigid = at_sensors(built, excited.loads.rigid),
                    .channels = {}};
  for (const BuiltSensor& s : built.sensors)
    for (const char* axis : axis_names) model.channels.emplace_back(s.name, axis);
  return model;
}

MatrixXcd acceleration_of(const SensorModel& model, const ExcitedColumns& excited,
                          const VectorXd& hertz) {
  const VectorXd omega = 2 * std::numbers::pi * hertz;
  MatrixXcd acceleration = -(omega.cwiseAbs2().asDiagonal() * model.relative(excited, hertz));
  Eigen::RowVectorXcd carried = Eigen::RowVectorXcd::Zero(acceleration.cols());
  for (const auto& [column, factor] : excited)
    carried += factor * model.rigid.col(column).transpose();
  acceleration.rowwise() += carried;
  return acceleration;
}

MatrixXd at_sensors(const BuiltCase& built, const MatrixXd& u) {
  MatrixXd rows(3 * built.sensors.size(), u.cols());
  for (std::size_t s = 0; s < built.sensors.size(); ++s)
    for (std::size_t k = 0; k < 3; ++k) {
      const int axis = built.sensors[s].axes[k];
      rows.row(Index(3 * s + k)) =
          sign_of(axis) * u.row(6 * built.sensors[s].node + axis_of_signed(axis));
    }
  return rows;
}

} // namespace plica

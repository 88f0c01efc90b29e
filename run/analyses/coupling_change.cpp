#include "run/analyses/coupling_change.hpp"

#include "solve/modes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXd;

double ringing_samples(const DampedModes& modes, double dt) {
  double slowest = 1e300; // per second
  for (int j = 0; j < modes.solution.modes; ++j)
    slowest =
        std::min(slowest, 2 * std::numbers::pi * frequency_of(modes, j) * damping_of(modes, j));
  return 10 / (slowest * dt);
}

std::optional<TransformLines> transform_lines(double samples, double dt, const ModalModel& by_mode,
                                              Index series, double room) {
  constexpr double most = 1 << 22;
  if (!(samples < most)) return std::nullopt;
  TransformLines lines{.length = 4, .count = 0, .spacing = 0};
  while (double(lines.length) < samples) lines.length *= 2;
  lines.spacing = 1 / (double(lines.length) * dt);
  const double highest = 2 * frequency(by_mode.lambda.maxCoeff());
  lines.count = std::min(lines.length / 2, Index(std::ceil(highest / lines.spacing)));
  if (double(lines.count) * double(series) > room) return std::nullopt;
  return lines;
}

void for_each_change(const TransformLines& lines, const SensorModel& model,
                     const ExcitedColumns& excited, const ModalModel& by_mode,
                     const Eigen::RowVectorXd& carried, const TakeChange& take) {
  constexpr Index block = 2048;
  for (Index first = 1; first < lines.count; first += block) {
    const Index count = std::min(block, lines.count - first);
    const VectorXd hertz =
        lines.spacing * VectorXd::LinSpaced(count, double(first), double(first + count - 1));
    const VectorXd omega = 2 * std::numbers::pi * hertz;
    MatrixXcd change =
        acceleration_of(model, excited, hertz) +
        MatrixXcd(omega.cwiseAbs2().asDiagonal() * frequency_response(by_mode, 0, omega));
    change.rowwise() -= carried.cast<std::complex<double>>();
    take(first, omega, change);
  }
}

std::string too_long_for_coupling(const std::string& what) {
  return what + " is long: damped springs and coupled loss factors act as damping of each mode by "
                "itself";
}

} // namespace plica

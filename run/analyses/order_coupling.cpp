#include "run/analyses/order_coupling.hpp"

#include "solve/modes.hpp"

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
constexpr double two_pi = 2 * std::numbers::pi;

// Samples until the mode that rings longest has died out to e^-10.
double samples_of_ringing(const DampedModes& modes, double dt) {
  double slowest = 1e300;
  for (int j = 0; j < modes.solution.modes; ++j)
    slowest = std::min(slowest, two_pi * frequency_of(modes, j) * damping_of(modes, j));
  return std::ceil(10 / (slowest * dt));
}

// A load with its lead at the first speed, zeros behind.
VectorXcd running(const SweptLoad& load, Index column, Index lead, Index length) {
  VectorXcd x = VectorXcd::Zero(length);
  for (Index i = 0; i < lead; ++i)
    x[i] = std::polar(load.amplitude(0, column),
                      load.phase[0] - load.rate[0] * load.dt * double(lead - i));
  for (Index i = 0; i < load.phase.size(); ++i)
    x[lead + i] = std::polar(load.amplitude(i, column), load.phase[i]);
  return x;
}

} // namespace

bool add_order_coupling(MatrixXcd& Z, const SensorModel& model, const DampedModes& modes,
                        const ModalModel& by_mode, const std::vector<int>& columns,
                        const VectorXcd& factors, const SweptLoad& load, Index stride) {
  constexpr double most = 1 << 22, room = 1e7; // samples, numbers
  constexpr Index block = 2048;
  const double ringing = samples_of_ringing(modes, load.dt);
  const double wanted = double(load.phase.size()) + 2 * ringing;
  if (!(wanted < most)) return false;
  const auto lead = Index(ringing);
  Index length = 4;
  while (double(length) < wanted) length *= 2;
  const double line = 1 / (double(length) * load.dt);
  const double highest = 2 * frequency(by_mode.lambda.maxCoeff());
  const Index lines = std::min(length / 2, Index(std::ceil(highest / line)));
  if (double(lines) * double(Z.cols()) * 2 > room) return false;
  Eigen::FFT<double> transform;
  MatrixXcd above = MatrixXcd::Zero(lines, Z.cols()), below = above; // of zero frequency
  for (std::size_t k = 0; k < columns.size(); ++k) {
    VectorXcd x = running(load, Index(k), lead, length), spectrum;
    transform.fwd(spectrum, x);
    spectrum *= factors[Index(k)];
    ModalModel alone = by_mode;
    alone.input = by_mode.input.col(Index(k)).eval();
    const Eigen::RowVectorXcd carried = model.rigid.col(columns[k]).transpose();
    for (Index first = 1; first < lines; first += block) {
      const Index count = std::min(block, lines - first);
      const VectorXd hertz =
          line * VectorXd::LinSpaced(count, double(first), double(first + count - 1));
      const VectorXd omega = two_pi * hertz;
      MatrixXcd change =
          acceleration_of(model, {{columns[k], 1.}}, hertz) +
          MatrixXcd(omega.cwiseAbs2().asDiagonal() * frequency_response(alone, 0, omega));
      change.rowwise() -= carried;
      for (Index i = 0; i < count; ++i) {
        above.row(first + i) += spectrum[first + i] * change.row(i);
        below.row(first + i) += spectrum[length - first - i] * change.row(i).conjugate();
      }
    }
  }
  for (Index c = 0; c < Z.cols(); ++c) {
    VectorXcd spectrum = VectorXcd::Zero(length), motion;
    spectrum.head(lines) = above.col(c);
    for (Index i = 1; i < lines; ++i) spectrum[length - i] += below(i, c);
    transform.inv(motion, spectrum);
    for (Index i = 0; i < Z.rows(); ++i)
      Z(i, c) += motion[lead + i * stride] * std::polar(1., -load.phase[i * stride]);
  }
  return true;
}

} // namespace plica

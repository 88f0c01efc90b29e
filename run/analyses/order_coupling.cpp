#include "run/analyses/order_coupling.hpp"

#include "run/analyses/coupling_change.hpp"

#include <unsupported/Eigen/FFT>

#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

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
  constexpr double room = 1e7; // numbers
  const double ringing = std::ceil(ringing_samples(modes, load.dt));
  const auto lines = transform_lines(double(load.phase.size()) + 2 * ringing, load.dt, by_mode,
                                     2 * Z.cols(), room);
  if (!lines) return false;
  const auto lead = Index(ringing);
  const Index length = lines->length;
  Eigen::FFT<double> transform;
  MatrixXcd above = MatrixXcd::Zero(lines->count, Z.cols()), below = above; // of zero frequency
  for (std::size_t k = 0; k < columns.size(); ++k) {
    VectorXcd x = running(load, Index(k), lead, length), spectrum;
    transform.fwd(spectrum, x);
    spectrum *= factors[Index(k)];
    ModalModel alone = by_mode;
    alone.input = by_mode.input.col(Index(k)).eval();
    for_each_change(
        *lines, model, {{columns[k], 1.}}, alone, model.rigid.col(columns[k]).transpose(),
        [&](Index first, const VectorXd& omega, const MatrixXcd& change) {
          for (Index i = 0; i < omega.size(); ++i) {
            above.row(first + i) += spectrum[first + i] * change.row(i);
            below.row(first + i) += spectrum[length - first - i] * change.row(i).conjugate();
          }
        });
  }
  for (Index c = 0; c < Z.cols(); ++c) {
    VectorXcd spectrum = VectorXcd::Zero(length), motion;
    spectrum.head(lines->count) = above.col(c);
    for (Index i = 1; i < lines->count; ++i) spectrum[length - i] += below(i, c);
    transform.inv(motion, spectrum);
    for (Index i = 0; i < Z.rows(); ++i)
      Z(i, c) += motion[lead + i * stride] * std::polar(1., -load.phase[i * stride]);
  }
  return true;
}

} // namespace plica

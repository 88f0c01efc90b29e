#include "solve/transient_response.hpp"

#include "solve/oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <vector>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

// Acceleration of a mode that follows the load statically: the second difference of f / omega^2;
// none at the last sample, beyond which nothing is known.
double static_acceleration(const VectorXd& f, Index i, double dt, double lambda) {
  if (i + 1 == f.size()) return 0;
  const double before = i > 0 ? f[i - 1] : 0;
  return (before - 2 * f[i] + f[i + 1]) / (dt * dt * lambda);
}

// Of every column; none: it follows the load statically.
std::vector<std::optional<Oscillator>> oscillators_of(const ModalModel& model, const MatrixXd& load,
                                                      double dt) {
  if (load.rows() < 2 || load.cols() != model.input.cols() || !(dt > 0) ||
      !(model.lambda.array() > 0).all())
    throw std::invalid_argument("transient: at least two samples of every load, a step above zero "
                                "and modes with stiffness");
  const Index modes = model.lambda.size();
  const double fastest = std::numbers::pi / dt; // rad/s, half of the sampling rate
  std::vector<std::optional<Oscillator>> oscillators(static_cast<std::size_t>(modes));
  for (Index j = 0; j < modes; ++j) {
    const double omega = std::sqrt(model.lambda[j]);
    if (omega < fastest)
      oscillators[std::size_t(j)].emplace(omega,
                                          std::min(model.zeta[j] + model.eta[j] / 2, 1 - 1e-9), dt);
  }
  return oscillators;
}

} // namespace

MatrixXd transient_coordinates(const ModalModel& model, const MatrixXd& load, double dt) {
  std::vector<std::optional<Oscillator>> oscillators = oscillators_of(model, load, dt);
  MatrixXd q(load.rows(), model.lambda.size());
#pragma omp parallel for schedule(static)
  for (Index j = 0; j < q.cols(); ++j) {
    const VectorXd f = load * model.input.row(j).transpose();
    std::optional<Oscillator>& o = oscillators[std::size_t(j)];
    for (Index i = 0; i < q.rows(); ++i) {
      if (o && i > 0) o->step(f[i - 1], f[i]);
      q(i, j) = o ? o->q() : f[i] / model.lambda[j];
    }
  }
  return q;
}

MatrixXd transient_acceleration(const ModalModel& model, const MatrixXd& load, double dt) {
  std::vector<std::optional<Oscillator>> oscillators = oscillators_of(model, load, dt);
  const Index modes = model.lambda.size(), samples = load.rows();
  MatrixXd channels(samples, model.output.rows());
  constexpr Index block = 4096; // samples whose modal accelerations stay in the cache
  MatrixXd acceleration(std::min(block, samples), modes);
  for (Index first = 0; first < samples; first += block) {
    const Index count = std::min(block, samples - first);
#pragma omp parallel for schedule(static)
    for (Index j = 0; j < modes; ++j) {
      // One sample more on either side.
      const Index from = std::max<Index>(first - 1, 0), to = std::min(first + count + 1, samples);
      const VectorXd f = load.middleRows(from, to - from) * model.input.row(j).transpose();
      std::optional<Oscillator>& o = oscillators[std::size_t(j)];
      for (Index i = first; i < first + count; ++i) {
        const Index k = i - from;
        if (o && i > 0) o->step(f[k - 1], f[k]);
        acceleration(i - first, j) =
            o ? o->acceleration(f[k]) : static_acceleration(f, k, dt, model.lambda[j]);
      }
    }
    channels.middleRows(first, count).noalias() =
        acceleration.topRows(count) * model.output.transpose();
  }
  return channels;
}

} // namespace plica

#include "solve/transient_response.hpp"

#include "solve/dense_product.hpp"
#include "solve/oscillator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Oscillators side by side: a step waits for the one before it, so four take as long as one.
class Four {
public:
  static constexpr Index width = 4;
  using Lane = Eigen::Array<double, width, 1>;

  Four() { c_.fill(Lane::Zero()); }

  void set(Index lane, const Oscillator& oscillator) {
    const Oscillator::Coefficients& c = oscillator.coefficients();
    const std::array all{c.stiff, c.damp, c.qq, c.qv, c.vq, c.vv, c.q0, c.q1, c.v0, c.v1};
    for (std::size_t i = 0; i < all.size(); ++i) c_[i][lane] = all[i];
  }

  // Loads of a stretch of samples and accelerations, width x samples. The first sample of all is
  // the beginning, from rest.
  void run(const MatrixXd& f, Eigen::Ref<MatrixXd> a) {
    const auto& [stiff, damp, qq, qv, vq, vv, q0, q1, v0, v1] = c_;
    Lane q = q_, v = v_, before = before_;
    for (Index i = 0; i < f.cols(); ++i) {
      const Lane now = f.col(i).array();
      if (begun_) {
        const Lane moved = qq * q + qv * v + q0 * before + q1 * now;
        v = vq * q + vv * v + v0 * before + v1 * now;
        q = moved;
      }
      begun_ = true;
      a.col(i) = now - damp * v - stiff * q;
      before = now;
    }
    q_ = q;
    v_ = v;
    before_ = before;
  }

private:
  std::array<Lane, 10> c_;
  Lane q_ = Lane::Zero(), v_ = Lane::Zero(), before_ = Lane::Zero();
  bool begun_ = false;
};

// Acceleration of a mode that follows the load statically: the second difference of f / omega^2;
// none at the last sample, beyond which nothing is known.
double static_acceleration(const VectorXd& f, Index i, double dt, double lambda) {
  if (i + 1 == f.size()) return 0;
  const double before = i > 0 ? f[i - 1] : 0;
  return (before - 2 * f[i] + f[i + 1]) / (dt * dt * lambda);
}

void require_sound(const ModalModel& model, const MatrixXd& load, double dt) {
  if (load.rows() < 2 || load.cols() != model.input.cols() || !(dt > 0) ||
      !(model.lambda.array() > 0).all())
    throw std::invalid_argument("transient: at least two samples of every load, a step above zero "
                                "and modes with stiffness");
}

Oscillator oscillator_of(const ModalModel& model, Index j, double dt) {
  return {std::sqrt(model.lambda[j]), std::min(model.zeta[j] + model.eta[j] / 2, 1 - 1e-9), dt};
}

} // namespace

MatrixXd transient_coordinates(const ModalModel& model, const MatrixXd& load, double dt) {
  require_sound(model, load, dt);
  MatrixXd q(load.rows(), model.lambda.size());
#pragma omp parallel for schedule(static)
  for (Index j = 0; j < q.cols(); ++j) {
    const VectorXd f = load * model.input.row(j).transpose();
    if (std::sqrt(model.lambda[j]) >= std::numbers::pi / dt) {
      q.col(j) = f / model.lambda[j]; // follows the load
      continue;
    }
    Oscillator oscillator = oscillator_of(model, j, dt);
    for (Index i = 0; i < q.rows(); ++i) {
      if (i > 0) oscillator.step(f[i - 1], f[i]);
      q(i, j) = oscillator.q();
    }
  }
  return q;
}

MatrixXd transient_acceleration(const ModalModel& model, const MatrixXd& load, double dt) {
  require_sound(model, load, dt);
  const Index samples = load.rows();
  const double fastest = std::numbers::pi / dt; // rad/s, half of the sampling rate
  std::vector<Index> ringing, following;
  for (Index j = 0; j < model.lambda.size(); ++j)
    (std::sqrt(model.lambda[j]) < fastest ? ringing : following).push_back(j);
  const Index groups = (Index(ringing.size()) + Four::width - 1) / Four::width;
  const Index rows = groups * Four::width + Index(following.size()); // unused lanes stay at rest
  std::vector<Four> fours(static_cast<std::size_t>(groups));
  MatrixXd input = MatrixXd::Zero(rows, load.cols()),
           output = MatrixXd::Zero(rows, model.output.rows());
  for (Index r = 0; r < Index(ringing.size()); ++r) {
    const Index j = ringing[std::size_t(r)];
    fours[std::size_t(r / Four::width)].set(r % Four::width, oscillator_of(model, j, dt));
    input.row(r) = model.input.row(j);
    output.row(r) = model.output.col(j).transpose();
  }
  for (std::size_t k = 0; k < following.size(); ++k)
    output.row(groups * Four::width + Index(k)) = model.output.col(following[k]).transpose();
  MatrixXd channels(samples, model.output.rows());
  // Samples whose modal accelerations stay in the cache. One thread: a second one would wait for
  // the first at every block, and the product below is half of the work.
  constexpr Index block = 2048;
  MatrixXd acceleration(rows, std::min(block, samples));
  for (Index first = 0; first < samples; first += block) {
    const Index count = std::min(block, samples - first);
    for (Index g = 0; g < groups; ++g) {
      const Index row = g * Four::width;
      const MatrixXd f =
          input.middleRows(row, Four::width) * load.middleRows(first, count).transpose();
      fours[std::size_t(g)].run(f, acceleration.block(row, 0, Four::width, count));
    }
    for (std::size_t k = 0; k < following.size(); ++k) {
      // One sample more on either side.
      const Index j = following[k];
      const Index from = std::max<Index>(first - 1, 0), to = std::min(first + count + 1, samples);
      const VectorXd f = load.middleRows(from, to - from) * model.input.row(j).transpose();
      for (Index i = first; i < first + count; ++i)
        acceleration(groups * Four::width + Index(k), i - first) =
            static_acceleration(f, i - from, dt, model.lambda[j]);
    }
    channels.middleRows(first, count) = transposed_product(acceleration.leftCols(count), output);
  }
  return channels;
}

} // namespace plica

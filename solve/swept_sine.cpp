#include "solve/swept_sine.hpp"

#include "solve/oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plica {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
constexpr Complex swept_i(0, 1);

// What a straight line between its samples leaves of the sine.
VectorXd left_of(const SweptLoad& load) {
  return load.rate.unaryExpr([&](double rate) {
    const double half = rate * load.dt / 2, sinc = half > 0 ? std::sin(half) / half : 1;
    return sinc * sinc;
  });
}

// Acceleration of a mode under the load f, with what the line loses given back, at every stride-th
// sample.
VectorXcd ringing(const VectorXcd& f, const VectorXd& left, double omega, double zeta,
                  const SweptLoad& load, Index stride) {
  Oscillator real(omega, zeta, load.dt), imaginary(omega, zeta, load.dt);
  const double W = load.rate[0];
  const Complex q = f[0] / (omega * omega - W * W + 2. * swept_i * zeta * omega * W);
  const Complex v = swept_i * W * q;
  real.begin(q.real(), v.real());
  imaginary.begin(q.imag(), v.imag());
  VectorXcd a((f.size() - 1) / stride + 1);
  Complex before = f[0] / left[0];
  for (Index i = 0; i < f.size(); ++i) {
    const Complex now = f[i] / left[i];
    if (i > 0) {
      real.step(before.real(), now.real());
      imaginary.step(before.imag(), now.imag());
    }
    if (i % stride == 0)
      a[i / stride] = {real.acceleration(f[i].real()), imaginary.acceleration(f[i].imag())};
    before = now;
  }
  return a;
}

// Of one that is faster than half of the sampling rate and follows statically: the second
// difference of the load, which loses of the sine what was given back.
VectorXcd following(const VectorXcd& f, const VectorXd& left, double lambda, const SweptLoad& load,
                    Index stride) {
  VectorXcd a((f.size() - 1) / stride + 1);
  for (Index i = 0; i < f.size(); i += stride) {
    const Index k = std::clamp<Index>(i, 1, f.size() - 2);
    a[i / stride] = (f[k - 1] - 2. * f[k] + f[k + 1]) / (load.dt * load.dt * lambda * left[k]);
    if (k != i) a[i / stride] *= std::polar(1., load.phase[i] - load.phase[k]);
  }
  return a;
}

} // namespace

MatrixXcd swept_acceleration(const ModalModel& model, const VectorXcd& factors,
                             const SweptLoad& load, Index stride) {
  const Index samples = load.phase.size(), modes = model.lambda.size();
  if (samples < 3 || !(load.dt > 0) || load.rate.size() != samples ||
      load.amplitude.rows() != samples || load.amplitude.cols() != model.input.cols() ||
      factors.size() != model.input.cols() || stride < 1 || !(model.lambda.array() > 0).all())
    throw std::invalid_argument(
        "swept sine: at least three samples of every load, a step above zero "
        "and modes with stiffness");
  const VectorXd left = left_of(load);
  const VectorXcd turn = load.phase.unaryExpr([](double phase) { return std::polar(1., phase); });
  const double fastest = std::numbers::pi / load.dt;
  MatrixXcd acceleration((samples - 1) / stride + 1, modes);
#pragma omp parallel for schedule(dynamic)
  for (Index j = 0; j < modes; ++j) {
    const VectorXcd share = factors.cwiseProduct(model.input.row(j).transpose());
    const VectorXcd f = turn.cwiseProduct(load.amplitude * share);
    const double omega = std::sqrt(model.lambda[j]);
    const double zeta = std::min(model.zeta[j] + model.eta[j] / 2, 1 - 1e-9);
    acceleration.col(j) = omega < fastest ? ringing(f, left, omega, zeta, load, stride)
                                          : following(f, left, model.lambda[j], load, stride);
  }
  for (Index i = 0; i < acceleration.rows(); ++i)
    acceleration.row(i) *= std::polar(1., -load.phase[i * stride]);
  return acceleration * model.output.transpose();
}

} // namespace plica

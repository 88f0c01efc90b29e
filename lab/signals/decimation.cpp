#include "lab/signals/decimation.hpp"

#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double attenuation = 80; // dB

// From 1 to `pass` down to nothing at `stop`, both over the sampling rate.
VectorXd low_pass(double pass, double stop) {
  const double beta = 0.1102 * (attenuation - 8.7);
  const auto half =
      Index(std::ceil((attenuation - 7.95) / (2.285 * 2 * std::numbers::pi * (stop - pass)) / 2));
  VectorXd h(2 * half + 1);
  const double cut = pass + stop; // twice the middle
  for (Index n = -half; n <= half; ++n) {
    const double x = std::numbers::pi * cut * double(n);
    const double inside = 1 - std::pow(double(n) / double(half), 2);
    h[n + half] = (n == 0 ? cut : cut * std::sin(x) / x) *
                  std::cyl_bessel_i(0., beta * std::sqrt(std::max(0., inside)));
  }
  return h / h.sum();
}

} // namespace

Decimated decimated(const Eigen::MatrixXd& samples, double rate, double high) {
  const auto factor = high > 0 ? int(rate / (4 * high)) : 1;
  if (factor < 2) return {.samples = samples, .rate = rate, .factor = 1};
  const VectorXd h = low_pass(high / rate, 1. / factor - high / rate);
  const Index count = samples.rows() < h.size() ? 0 : (samples.rows() - h.size()) / factor + 1;
  Decimated d{
      .samples = Eigen::MatrixXd(count, samples.cols()), .rate = rate / factor, .factor = factor};
  for (Index n = 0; n < count; ++n)
    d.samples.row(n) = h.transpose() * samples.middleRows(n * factor, h.size());
  return d;
}

} // namespace plica

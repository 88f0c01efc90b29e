#include "lab/identification/decay_fit.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

VectorXcd exponential(const VectorXd& t, const Complex& pole) {
  return (t.cast<Complex>() * pole).array().exp();
}

// Re(R e) = Re R Re e - Im R Im e.
MatrixXd decay_columns(const VectorXd& t, const Poles& poles) {
  MatrixXd A(t.size(), 2 * Index(poles.size()) + 1);
  for (Index r = 0; r < Index(poles.size()); ++r) {
    const VectorXcd e = exponential(t, poles[std::size_t(r)]);
    A.col(2 * r) = e.real();
    A.col(2 * r + 1) = -e.imag();
  }
  A.rightCols(1).setOnes();
  return A;
}

// d e / d Re l = t e, d e / d Im l = i t e.
MatrixXd decay_derivatives(const VectorXd& t, const Poles& poles) {
  MatrixXd D(t.size(), 4 * Index(poles.size()));
  for (Index r = 0; r < Index(poles.size()); ++r) {
    const VectorXcd e = exponential(t, poles[std::size_t(r)]);
    D.col(4 * r) = t.cwiseProduct(e.real());
    D.col(4 * r + 1) = -t.cwiseProduct(e.imag());
    D.col(4 * r + 2) = -t.cwiseProduct(e.imag());
    D.col(4 * r + 3) = -t.cwiseProduct(e.real());
  }
  return D;
}

VectorXd times(Index samples, double rate) {
  return VectorXd::LinSpaced(samples, 0, double(samples - 1) / rate);
}

} // namespace

ModalFit fit_decays(const Decays& decays, double rate, const Poles& poles, int iterations) {
  const Index samples = decays[0].rows(), channels = decays[0].cols();
  const Index count = Index(decays.size()), modes = Index(poles.size());
  if (samples < 2 * modes + 3)
    throw std::invalid_argument(std::to_string(samples) + " samples are too few for " +
                                std::to_string(modes) + " poles");
  MatrixXd data(samples, channels * count);
  for (Index d = 0; d < count; ++d)
    data.middleCols(d * channels, channels) = decays[std::size_t(d)];
  const VectorXd t = times(samples, rate);
  const PoleBasis basis{.columns = [&](const Poles& p) { return decay_columns(t, p); },
                        .derivatives = [&](const Poles& p) { return decay_derivatives(t, p); },
                        .lines = samples};
  const double size = data.norm() / std::sqrt(double(data.size()));
  const VectorXd noise =
      (data.colwise().norm() / std::sqrt(double(samples))).transpose().cwiseMax(1e-9 * size);
  return fit_of(search_poles(basis, data, noise, poles, iterations), channels, count);
}

Decays synthesised_decays(const ModalFit& fit, double rate, Index samples) {
  const VectorXd t = times(samples, rate);
  Decays decays(std::size_t(fit.lower.cols()));
  for (std::size_t d = 0; d < decays.size(); ++d) {
    decays[d] = fit.lower.col(Index(d)).transpose().replicate(samples, 1);
    for (const FittedMode& m : fit.modes)
      decays[d] += (exponential(t, m.lambda) * m.residue.col(Index(d)).transpose()).real();
  }
  return decays;
}

} // namespace plica

#include "lab/signals/frf_estimate.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Complex = std::complex<double>;

Complex total_least_squares(Complex xx, Complex xy, double yy) {
  Eigen::Matrix2cd S;
  S << xx.real(), xy, std::conj(xy), yy;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2cd> modes(S);
  // S = conj(X) X', so its vectors are conjugate to those of the signals.
  const Eigen::Vector2cd u = modes.eigenvectors().col(1).conjugate();
  return u[0] == 0. ? 0. : u[1] / u[0];
}

} // namespace

FrfEstimate estimate_frf(const Spectra& s, FrfEstimator estimator) {
  const Index inputs = s.xx.empty() ? 0 : s.xx[0].rows(), responses = s.yy.cols();
  if (inputs < 1) throw std::invalid_argument("a frequency response needs an input");
  if (inputs > 1 && estimator != FrfEstimator::H1)
    throw std::invalid_argument("H2 and Hv take one input; with several take H1");
  FrfEstimate result;
  result.hertz = s.hertz;
  result.averages = s.averages;
  result.H.assign(inputs, MatrixXcd::Zero(s.hertz.size(), responses));
  result.coherence = Eigen::MatrixXd::Zero(s.hertz.size(), responses);
  for (Index f = 0; f < s.hertz.size(); ++f) {
    // S_xy = S_xx H, with H inputs x responses.
    const Eigen::ColPivHouseholderQR<MatrixXcd> factor(s.xx[f]);
    if (factor.rank() < inputs) continue;
    const MatrixXcd H1 = factor.solve(s.xy[f]);
    for (Index y = 0; y < responses; ++y) {
      const double yy = s.yy(f, y);
      const double linear = s.xy[f].col(y).dot(H1.col(y)).real();
      result.coherence(f, y) = yy > 0 ? std::min(1., linear / yy) : 0;
      for (Index x = 0; x < inputs; ++x) {
        Complex h = H1(x, y);
        if (estimator == FrfEstimator::H2)
          h = s.xy[f](0, y) == 0. ? 0. : yy / std::conj(s.xy[f](0, y));
        if (estimator == FrfEstimator::Hv)
          h = total_least_squares(s.xx[f](0, 0), s.xy[f](0, y), yy);
        result.H[x](f, y) = h;
      }
    }
  }
  return result;
}

double frf_random_error(double coherence, double averages) {
  if (!(coherence > 0)) return std::numeric_limits<double>::infinity();
  return std::sqrt((1 - coherence) / (coherence * 2 * averages));
}

} // namespace plica

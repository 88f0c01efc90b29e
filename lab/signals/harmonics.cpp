#include "lab/signals/harmonics.hpp"

#include "lab/signals/fourier.hpp"

#include <cmath>

namespace plica {

bool is_sine(const BandKurtosis& k) {
  return k.lines > 0 && k.value < 2.25 && (k.value < 3 - 3 * k.sigma || k.lines < 4);
}

BandKurtosis band_kurtosis(const Eigen::VectorXd& x, double rate, double low, double high) {
  Fourier transform{int(x.size())};
  Eigen::VectorXcd X = transform.forward(x);
  const double line = rate / double(x.size());
  double sum = 0, squares = 0;
  for (Eigen::Index k = 0; k < X.size(); ++k) {
    const double f = double(k) * line;
    if (f < low || f > high) X[k] = 0;
    sum += std::norm(X[k]);
    squares += std::norm(X[k]) * std::norm(X[k]);
  }
  const Eigen::ArrayXd y = transform.inverse(X).array();
  const double square = y.square().mean();
  BandKurtosis result;
  if (!(square > 0)) return result;
  result.value = y.square().square().mean() / (square * square);
  result.lines = sum * sum / squares;
  result.sigma = std::sqrt(12 / result.lines);
  return result;
}

} // namespace plica

#include "lab/signals/time_correlation.hpp"

#include "lab/signals/fourier.hpp"

#include <cmath>
#include <stdexcept>

namespace plica {

using Eigen::VectorXd;

TimeCorrelation correlate_in_time(const VectorXd& a, const VectorXd& b, double rate,
                                  int largest_lag) {
  const int n = static_cast<int>(a.size());
  if (b.size() != a.size()) throw std::invalid_argument("the signals differ in length");
  if (largest_lag < 1 || largest_lag >= n)
    throw std::invalid_argument("the largest lag must lie between 1 and the length of the signals");
  const int padded = n + largest_lag; // zeros keep the ends from meeting
  Fourier transform(padded);
  VectorXd x = VectorXd::Zero(padded), y = x;
  x.head(n) = a.array() - a.mean();
  y.head(n) = b.array() - b.mean();
  const double scale = x.norm() * y.norm() / n;
  const VectorXd r =
      transform.inverse(transform.forward(x).conjugate().cwiseProduct(transform.forward(y)));
  TimeCorrelation result;
  const int count = 2 * largest_lag + 1;
  result.lag.resize(count);
  result.value.resize(count);
  for (int i = 0; i < count; ++i) {
    const int m = i - largest_lag;
    result.lag[i] = m / rate;
    result.value[i] = r[m >= 0 ? m : padded + m] / (n - std::abs(m));
  }
  result.coefficient = scale > 0 ? VectorXd(result.value / scale) : VectorXd::Zero(count);
  return result;
}

} // namespace plica

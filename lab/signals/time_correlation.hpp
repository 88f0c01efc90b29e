// Auto- and cross-correlation of signals.
//
//   R_ab(m) = 1/(N - |m|) sum_n a_n b_{n+m}      unbiased, without the means
#pragma once

#include <Eigen/Core>

namespace plica {

struct TimeCorrelation {
  Eigen::VectorXd lag;         // s, from -largest to +largest
  Eigen::VectorXd value;       // unit_a unit_b
  Eigen::VectorXd coefficient; // value / (sigma_a sigma_b)
};

// Throws std::invalid_argument unless both have one length and 0 < largest_lag < length.
TimeCorrelation correlate_in_time(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double rate,
                                  int largest_lag);

} // namespace plica

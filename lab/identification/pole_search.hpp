// Poles whose parts explain data best, y = A(poles) C + noise, by least squares.
//
// Given the poles the coefficients C are linear and are eliminated (variable projection, Golub and
// Pereyra 1973; Kaufman's Jacobian); the poles follow by Levenberg-Marquardt. The covariance is
// that of the linearised problem for the residual that is there, not for white noise alone.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <vector>

namespace plica {

using Poles = std::vector<std::complex<double>>; // 1/s

// The columns of A: for each pole that of the real part of its amplitude, then that of the
// imaginary part; behind them those that depend on no pole.
struct PoleBasis {
  std::function<Eigen::MatrixXd(const Poles&)> columns;
  // Of the two columns of each pole by its real part, then of both by its imaginary part.
  std::function<Eigen::MatrixXd(const Poles&)> derivatives;
  Eigen::Index lines = 0; // rows i, i + lines, ... are of one measurement
};

struct PoleSearch {
  Poles poles;
  Eigen::MatrixXd C;      // parts of the columns x data, of the data as they are
  Eigen::VectorXd rms;    // of the residual, per column of data
  Eigen::VectorXd spread; // standard deviation of each row of C over rms
  Eigen::VectorXd sigma_real, sigma_imaginary; // of the poles, 1/s
  int iterations = 0;
  bool converged = false;
};

// `noise`: standard deviation per column of data to begin with; then what a first fit leaves. With
// no iterations the poles stay where they are and the rest is what it is there.
PoleSearch search_poles(const PoleBasis& basis, const Eigen::MatrixXd& data,
                        const Eigen::VectorXd& noise, const Poles& start, int iterations = 200);

} // namespace plica

// Readings in units of their standard deviations, correlations taken out.
#pragma once

#include "diagnose/weigh/uncertainty.hpp"

#include <Eigen/Cholesky>

namespace plica {

// Readings that are fitted, whitened.
class Whitening {
public:
  Whitening(const TestReadings& test, const Uncertainty& u, bool held_out);

  // With a further covariance, over all readings; empty = as it is.
  Whitening widened(const Eigen::MatrixXd& further) const;

  // Of deviations from nominal and bias, over all readings.
  Eigen::VectorXd operator()(const Eigen::VectorXd& deviation) const;
  const std::vector<Eigen::Index>& rows() const { return rows_; }
  double log_det() const; // of the covariance, halved

private:
  std::vector<Eigen::Index> rows_;
  Eigen::MatrixXd covariance_;
  Eigen::LLT<Eigen::MatrixXd> root_;
};

} // namespace plica

#include "diagnose/weigh/whitening.hpp"

namespace plica {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Whitening::Whitening(const TestReadings& test, const Uncertainty& u, bool held_out) {
  for (std::size_t i = 0; i < test.readings.size(); ++i)
    if (test.readings[i].held_out == held_out) rows_.push_back(Index(i));
  covariance_ = u.total()(rows_, rows_);
  root_.compute(covariance_);
}

Whitening Whitening::widened(const MatrixXd& further) const {
  Whitening wider = *this;
  if (further.size() == 0 || rows_.empty()) return wider;
  wider.covariance_ += further(rows_, rows_);
  wider.root_.compute(wider.covariance_);
  return wider;
}

double Whitening::log_det() const {
  return rows_.empty() ? 0 : MatrixXd(root_.matrixL()).diagonal().array().log().sum();
}

VectorXd Whitening::operator()(const VectorXd& deviation) const {
  if (rows_.empty()) return VectorXd();
  return root_.matrixL().solve(VectorXd(deviation(rows_)));
}

} // namespace plica

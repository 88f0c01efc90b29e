#include "lab/identification/state_space.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace plica {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

MatrixXd transition(const MatrixXd& O, Index channels) {
  const Index rows = O.rows() - channels;
  return O.topRows(rows).householderQr().solve(O.bottomRows(rows));
}

std::vector<Pole> poles_of_states(const MatrixXd& O, Index channels, double rate) {
  const Eigen::EigenSolver<MatrixXd> solver(transition(O, channels));
  std::vector<Pole> poles;
  if (solver.info() != Eigen::Success) return poles;
  const MatrixXcd shapes = O.topRows(channels) * solver.eigenvectors();
  for (Index j = 0; j < O.cols(); ++j) {
    const std::complex<double> mu = solver.eigenvalues()[j];
    if (mu.imag() <= 0 || std::abs(mu) >= 1 || std::abs(mu) < 1e-6) continue;
    Pole pole{.lambda = std::log(mu) * rate, .participation = shapes.col(j)};
    if (pole.damping() > 0.5 || !(pole.participation.norm() > 0)) continue;
    pole.participation.normalize();
    poles.push_back(std::move(pole));
  }
  std::sort(poles.begin(), poles.end(),
            [](const Pole& a, const Pole& b) { return a.frequency() < b.frequency(); });
  return poles;
}

std::vector<PolesOfOrder> poles_of_rising_order(const MatrixXd& O, Index channels, double rate) {
  std::vector<PolesOfOrder> all;
  for (Index n = 2; n <= O.cols(); n += 2)
    all.push_back({int(n / 2), poles_of_states(O.leftCols(n), channels, rate)});
  return all;
}

} // namespace plica

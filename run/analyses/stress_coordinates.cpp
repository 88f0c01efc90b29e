#include "run/analyses/stress_coordinates.hpp"

#include "life/spectral.hpp"

#include <numbers>

namespace plica {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

StressCoordinates::StressCoordinates(const DampedModes& modes, const Excitations* excited)
    : response_(modes, MatrixXd::Identity(modes.solution.u.cols(), modes.solution.u.cols())),
      fields_(modes.solution.u) {
  if (!excited) return;
  const Loads& loads = excited->loads;
  own_.assign(loads.base.size(), -1);
  for (std::size_t k = 0; k < own_.size(); ++k) {
    const VectorXd carried = loads.rigid.col(Index(k));
    if (loads.base[k] >= 0 || carried.isZero(0)) continue; // a rigid motion strains nothing
    own_[k] = int(fields_.cols());
    fields_.conservativeResize(Eigen::NoChange, fields_.cols() + 1);
    fields_.rightCols(1) = carried;
  }
}

bool StressCoordinates::strains(const ExcitedColumns& excited) const {
  for (const ExcitedColumn& part : excited)
    if (own_[std::size_t(part.column)] >= 0) return true;
  return false;
}

MatrixXcd StressCoordinates::operator()(const ExcitedColumns& excited,
                                        const VectorXd& hertz) const {
  const MatrixXcd modal = response_(excited, hertz);
  MatrixXcd q = MatrixXcd::Zero(hertz.size(), fields_.cols());
  q.leftCols(modal.cols()) = modal;
  for (const ExcitedColumn& part : excited)
    if (const int own = own_[std::size_t(part.column)]; own >= 0)
      q.col(own) -=
          part.factor * (2 * std::numbers::pi * hertz).array().square().inverse().matrix();
  return q;
}

MatrixXcd spectral_rows(const Excitation& e, const StressCoordinates& coordinates,
                        const VectorXd& hertz) {
  std::vector<MatrixXcd> unit;
  for (const ExcitedColumns& input : e.random_inputs) unit.push_back(coordinates(input, hertz));
  const auto inputs = Index(unit.size()), columns = unit[0].cols();
  MatrixXcd rows(hertz.size() * inputs, columns), Q(inputs, columns);
  for (Index i = 0; i < hertz.size(); ++i) {
    for (Index k = 0; k < inputs; ++k) Q.row(k) = unit[std::size_t(k)].row(i);
    rows.middleRows(i * inputs, inputs) =
        root_of_spectrum(spectrum_at(e.random, hertz[i])).transpose() * Q;
  }
  return rows;
}

MatrixXd covariance(const MatrixXcd& rows, const VectorXd& hertz, double n) {
  const VectorXd weights = moment_weights(hertz, n);
  const Index inputs = rows.rows() / hertz.size();
  MatrixXcd q = rows;
  for (Index i = 0; i < hertz.size(); ++i)
    q.middleRows(i * inputs, inputs) *= std::sqrt(std::max(0., weights[i]));
  return q.real().transpose() * q.real() + q.imag().transpose() * q.imag();
}

} // namespace plica

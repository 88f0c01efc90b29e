#include "lab/identification/mode_of_fit.hpp"

#include "lab/identification/mode_correlation.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

namespace plica {

using Eigen::MatrixXcd;
using Eigen::VectorXd;

namespace {

Poles poles_that_stand_out(const ModalFit& fit, double low, double high) {
  Poles kept;
  for (const FittedMode& m : fit.modes) {
    const std::complex<double> p = m.lambda;
    if (is_noise(m, low, high)) continue;
    if (std::none_of(kept.begin(), kept.end(), [&](const std::complex<double>& q) {
          return std::abs(p - q) < 0.1 * std::min(-p.real(), -q.real());
        }))
      kept.push_back(p);
  }
  return kept;
}

} // namespace

bool is_noise(const FittedMode& m, double low, double high) {
  const double f = m.frequency();
  if (f < low || f > high) return true;
  if (m.damping() > 0.5 || m.sigma_damping() > 0.5 * m.damping()) return true;
  return (m.residue.cwiseAbs().array() < 5 * m.sigma_residue.array()).all();
}

ModalFit fit_significant(const std::function<ModalFit(const Poles&)>& fit, Poles poles, double low,
                         double high) {
  ModalFit found = fit(poles);
  for (int round = 0; round < 4; ++round) {
    poles = poles_that_stand_out(found, low, high);
    if (poles.size() == found.modes.size()) break;
    found = fit(poles);
  }
  return found;
}

IdentifiedMode mode_of(const FittedMode& m) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  IdentifiedMode mode;
  mode.peak_frequency = mode.peak_damping = mode.circle_frequency = mode.circle_damping = nan;
  mode.frequency = m.frequency();
  mode.damping = m.damping();
  mode.sigma_frequency = m.sigma_frequency();
  mode.sigma_damping = m.sigma_damping();
  const Eigen::JacobiSVD<MatrixXcd> svd(m.residue, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const VectorXd& s = svd.singularValues();
  mode.rank = s.size() > 1 && s[0] > 0 ? s[1] / s[0] : 0;
  mode.shape = turned_real(svd.matrixU().col(0));
  mode.participation = svd.matrixV().col(0).conjugate();
  mode.collinearity = phase_collinearity(mode.shape);
  const VectorXd scatter =
      (m.sigma_residue.cwiseAbs2() * mode.participation.cwiseAbs2()).cwiseSqrt();
  mode.sigma_shape = s[0] > 0 ? VectorXd(scatter / s[0]) : scatter;
  const double largest = mode.shape.cwiseAbs().maxCoeff();
  mode.shape /= largest;
  mode.sigma_shape /= largest;
  return mode;
}

int orders_that_show(const std::vector<DiagramPole>& diagram, const IdentifiedMode& mode) {
  std::vector<int> orders;
  for (const DiagramPole& p : diagram)
    if (p.stability == Stability::all &&
        std::abs(p.pole.frequency() - mode.frequency) < 0.5 * mode.damping * mode.frequency &&
        (orders.empty() || orders.back() != p.order))
      orders.push_back(p.order);
  return static_cast<int>(orders.size());
}

} // namespace plica

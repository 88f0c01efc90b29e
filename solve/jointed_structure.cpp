#include "solve/jointed_structure.hpp"

#include <Eigen/LU>
#include <cmath>

namespace plica {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

namespace {

// 1 / D without the care for overflow that makes complex division slow.
VectorXcd inverse(const VectorXcd& D) {
  return D.unaryExpr([](const Complex& d) { return std::conj(d) / std::norm(d); });
}

} // namespace

VectorXcd added_at(const JointedStructure& s, int n, double omega) {
  VectorXcd g(Index(s.added.size()));
  for (Index k = 0; k < g.size(); ++k) g[k] = s.added[std::size_t(k)]({0, n * omega});
  if (n == 0) g = g.real().cast<Complex>().eval();
  return g;
}

VectorXcd added_slope(const JointedStructure& s, int n, double omega) {
  if (n == 0) return VectorXcd::Zero(Index(s.added.size()));
  const double h = 1e-6 * omega;
  return (added_at(s, n, omega + h) - added_at(s, n, omega - h)) / (2 * h);
}

DynamicStiffness::DynamicStiffness(const JointedStructure& s, int n, double omega)
    : s_(s), n_(n), omega_(omega) {
  const double W = n * omega;
  VectorXcd D(s.lambda.size());
  for (Index r = 0; r < D.size(); ++r)
    D[r] =
        Complex(s.lambda[r] - W * W,
                n == 0 ? 0 : s.lambda[r] * s.eta[r] + 2 * s.zeta[r] * std::sqrt(s.lambda[r]) * W);
  // A mode that springs alone damp has no motion without them at its own frequency.
  constexpr double least = 1e-8;
  for (Index r = 0; r < D.size() && !s.added.empty(); ++r)
    if (std::abs(D[r]) < least * s.lambda[r]) D[r] = Complex(0, least * s.lambda[r]);
  inverse_ = inverse(D);
  if (s.added.empty()) return;
  const VectorXcd G = added_at(s, n, omega);
  of_springs_ = inverse_.asDiagonal() * s.dampers;
  MatrixXcd A = G.asDiagonal() * (s.dampers.transpose() * of_springs_);
  A.diagonal().array() += 1;
  between_ = A.partialPivLu().solve(MatrixXcd(G.asDiagonal()));
}

MatrixXcd DynamicStiffness::solve(const MatrixXcd& force) const {
  MatrixXcd motion = inverse_.asDiagonal() * force;
  if (!s_.added.empty()) motion -= of_springs_ * (between_ * (s_.dampers.transpose() * motion));
  return motion;
}

VectorXcd DynamicStiffness::by_omega(const VectorXcd& motion) const {
  VectorXcd out(motion.size());
  for (Index r = 0; r < out.size(); ++r)
    out[r] =
        motion[r] * Complex(-2. * n_ * n_ * omega_, 2. * n_ * s_.zeta[r] * std::sqrt(s_.lambda[r]));
  if (!s_.added.empty())
    out += s_.dampers * added_slope(s_, n_, omega_).cwiseProduct(s_.dampers.transpose() * motion);
  return out;
}

} // namespace plica

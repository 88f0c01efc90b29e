#include "reduction/superelement.hpp"

#include "solve/couplings.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <stdexcept>

namespace plica {

using Eigen::MatrixXd;
using Eigen::Vector3d;

namespace {

MatrixXd rigid_motions(const std::vector<Vector3d>& nodes, const Vector3d& about) {
  MatrixXd R = MatrixXd::Zero(6 * Eigen::Index(nodes.size()), 6);
  for (std::size_t node = 0; node < nodes.size(); ++node)
    for (int m = 0; m < 6; ++m) {
      const auto at = 6 * static_cast<Eigen::Index>(node);
      R(at + m, m) = 1;
      if (m >= 3) R.block<3, 1>(at, m) = Vector3d(Vector3d::Unit(m - 3)).cross(nodes[node] - about);
    }
  return R;
}

} // namespace

MatrixXd rigid_motions(const Superelement& s, const Vector3d& about) {
  MatrixXd R = MatrixXd::Zero(s.K.rows(), 6);
  R.topRows(s.boundary()) = rigid_motions(s.nodes, about);
  return R;
}

MatrixXd without_grounding(const MatrixXd& K, const std::vector<Vector3d>& nodes) {
  constexpr double rounding = 1e-6;
  // Scaled to unit diagonal, so that N/m and Nm/rad count alike.
  const Eigen::VectorXd scale = K.diagonal().cwiseSqrt().cwiseInverse();
  const MatrixXd balanced = scale.asDiagonal() * K * scale.asDiagonal();
  const MatrixXd R = scale.cwiseInverse().asDiagonal() * rigid_motions(nodes, nodes.front());
  const Eigen::HouseholderQR<MatrixXd> qr(R);
  const MatrixXd Q = qr.householderQ() * MatrixXd::Identity(R.rows(), 6);
  if ((balanced * Q).norm() > rounding) return K;
  const MatrixXd P = MatrixXd::Identity(K.rows(), K.rows()) - Q * Q.transpose();
  const MatrixXd unscale = scale.cwiseInverse().asDiagonal();
  const MatrixXd clean = unscale * P * balanced * P * unscale;
  return (clean + clean.transpose()) / 2;
}

MassProperties mass_properties(const Eigen::Matrix<double, 6, 6>& m) {
  MassProperties p{.mass = m.topLeftCorner<3, 3>().trace() / 3, .centre = {0, 0, 0}, .inertia = {}};
  // M_ij of translation i and rotation j is m (e_j x c)_i: each first moment stands there twice.
  if (p.mass > 0)
    p.centre = Vector3d(m(1, 5) - m(2, 4), m(2, 3) - m(0, 5), m(0, 4) - m(1, 3)) / (2 * p.mass);
  const Vector3d& c = p.centre;
  p.inertia = m.bottomRightCorner<3, 3>() -
              p.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
  return p;
}

MassProperties mass_properties(const Superelement& s) {
  const MatrixXd R = rigid_motions(s, Vector3d::Zero());
  return mass_properties(Eigen::Matrix<double, 6, 6>(R.transpose() * s.M * R));
}

Superelement placed(const Superelement& s, const Eigen::Matrix3d& R, const Vector3d& t) {
  if ((R.transpose() * R - Eigen::Matrix3d::Identity()).norm() > 1e-10)
    throw std::invalid_argument("an instance is placed by a rotation or a mirror image, and this "
                                "matrix is neither");
  Eigen::Matrix<double, 6, 6> turn = Eigen::Matrix<double, 6, 6>::Zero();
  turn.topLeftCorner<3, 3>() = R;
  turn.bottomRightCorner<3, 3>() = (R.determinant() < 0 ? -1. : 1.) * R;
  MatrixXd T = MatrixXd::Identity(s.K.rows(), s.K.rows());
  for (int b = 0; b < s.boundary(); b += 6) T.block<6, 6>(b, b) = turn;
  Superelement instance = s;
  for (Vector3d& x : instance.nodes) x = R * x + t;
  for (MatrixXd* matrix : {&instance.K, &instance.M, &instance.C, &instance.D})
    if (matrix->size() > 0) *matrix = (T * *matrix * T.transpose()).eval();
  for (RecoveryRows& r : instance.recovery) {
    r.place = R * r.place + t;
    r.rows = (turn * r.rows * T.transpose()).eval();
  }
  return instance;
}

std::vector<int> add_superelement(Model& model, const Superelement& s,
                                  const std::vector<int>& nodes, int component) {
  const int points = (s.modal() + 5) / 6;
  MatrixElement element;
  element.nodes = nodes;
  element.component = component;
  std::vector<int> scalar;
  for (int k = 0; k < points; ++k) {
    scalar.push_back(add_node(model, s.nodes.front()));
    model.scalar_nodes.insert(scalar.back());
    element.nodes.push_back(scalar.back());
  }
  for (int unused = s.modal(); unused < 6 * points; ++unused)
    add_support(model, {scalar.back()}, {unused % 6}, "unused scalar point");
  const Eigen::Index all = s.boundary() + 6 * points;
  element.K = element.M = MatrixXd::Zero(all, all);
  element.K.topLeftCorner(s.K.rows(), s.K.rows()) = s.K;
  element.M.topLeftCorner(s.M.rows(), s.M.rows()) = s.M;
  model.matrices.push_back(std::move(element));
  return scalar;
}

} // namespace plica

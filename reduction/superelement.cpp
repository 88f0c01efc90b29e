#include "reduction/superelement.hpp"

#include "solve/couplings.hpp"
#include "solve/decompositions.hpp"
#include "solve/dense_product.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
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

// R s R' on both faces, s = xx yy zz xy yz zx.
Eigen::Matrix<double, 12, 12> turned_stress(const Eigen::Matrix3d& R) {
  constexpr std::array<std::array<int, 2>, 6> at{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};
  Eigen::Matrix<double, 12, 12> T = Eigen::Matrix<double, 12, 12>::Zero();
  for (int j = 0; j < 6; ++j) {
    Eigen::Matrix3d unit = Eigen::Matrix3d::Zero();
    unit(at[j][0], at[j][1]) = unit(at[j][1], at[j][0]) = 1;
    const Eigen::Matrix3d turned = R * unit * R.transpose();
    for (int i = 0; i < 6; ++i) T(i, j) = T(6 + i, 6 + j) = turned(at[i][0], at[i][1]);
  }
  return T;
}

} // namespace

MatrixXd rigid_motions(const Superelement& s, const Vector3d& about) {
  MatrixXd R = MatrixXd::Zero(s.K.rows(), 6);
  R.topRows(s.boundary()) = rigid_motions(s.nodes, about);
  return R;
}

namespace {

// Stiffness scaled to unit diagonal, so that N/m and Nm/rad count alike, and an orthonormal basis
// of the rigid motions in its coordinates.
struct Balanced {
  Eigen::VectorXd scale;
  MatrixXd K, Q;
};

Balanced balance(const MatrixXd& K, const std::vector<Vector3d>& nodes) {
  Balanced b;
  b.scale = K.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  b.K = b.scale.asDiagonal() * K * b.scale.asDiagonal();
  const MatrixXd R = b.scale.cwiseInverse().asDiagonal() * rigid_motions(nodes, nodes.front());
  b.Q = orthonormal_columns(R);
  return b;
}

} // namespace

double grounding(const MatrixXd& K, const std::vector<Vector3d>& nodes) {
  const Balanced b = balance(K, nodes);
  return (b.K * b.Q).norm();
}

MatrixXd without_grounding(const MatrixXd& K, const std::vector<Vector3d>& nodes,
                           double unreduced) {
  constexpr double rounding = 1e-6;
  // At a single node all motions are rigid: what stands there is a spring to ground, or rounding.
  if (nodes.size() == 1 && K.cwiseAbs().maxCoeff() < 1e-9 * unreduced)
    return MatrixXd::Zero(K.rows(), K.cols());
  const Balanced b = balance(K, nodes);
  if ((b.K * b.Q).norm() > rounding) return symmetrised(K);
  const MatrixXd P = MatrixXd::Identity(K.rows(), K.rows()) - b.Q * b.Q.transpose();
  const MatrixXd unscale = b.scale.cwiseInverse().asDiagonal();
  return symmetrised(unscale * P * b.K * P * unscale);
}

Eigen::VectorXd dynamic_stiffness(const Superelement& s, int row, int column,
                                  const Eigen::VectorXd& hertz) {
  const Eigen::Index b = s.boundary(), q = s.modal();
  const Eigen::ArrayXd lambda = s.K.bottomRightCorner(q, q).diagonal().array();
  const Eigen::ArrayXd both =
      s.M.col(row).tail(q).array() * s.M.col(column).tail(q).array(); // M_bq M_qb
  Eigen::VectorXd stiffness(hertz.size());
  for (Eigen::Index i = 0; i < hertz.size(); ++i) {
    const double w2 = std::pow(2 * std::numbers::pi * hertz[i], 2);
    stiffness[i] = s.K.topLeftCorner(b, b)(row, column) - w2 * s.M(row, column) -
                   w2 * w2 * (both / (lambda - w2)).sum();
  }
  return stiffness;
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

Superelement in_millimetres(const Superelement& s) {
  constexpr double mm = 1000;
  Superelement t = s;
  t.units = "mm t s N rad";
  // u' = scale u; energies are 1000 times the number in N mm.
  Eigen::VectorXd scale = Eigen::VectorXd::Constant(s.K.rows(), std::sqrt(mm));
  for (int b = 0; b < s.boundary(); b += 6) {
    scale.segment<3>(b).setConstant(mm);
    scale.segment<3>(b + 3).setOnes();
  }
  const Eigen::VectorXd down = scale.cwiseInverse();
  for (MatrixXd* A : {&t.K, &t.M, &t.C, &t.D})
    if (A->size() > 0) *A = (mm * (down.asDiagonal() * *A * down.asDiagonal())).eval();
  for (Vector3d& x : t.nodes) x *= mm;
  for (RecoveryRows& r : t.recovery) {
    r.place *= mm;
    r.rows = (r.rows * down.asDiagonal()).eval();
    r.rows.topRows<3>() *= mm;
  }
  for (StressRows& r : t.stresses) {
    r.place *= mm;
    r.rows = (r.rows * down.asDiagonal() * 1e-6).eval(); // MPa
  }
  // Work of a unit force is a thousand N mm per N m.
  for (LoadVector& load : t.loads) load.force = (mm * down.asDiagonal() * load.force).eval();
  return t;
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
  for (StressRows& r : instance.stresses) {
    r.place = R * r.place + t;
    r.rows = (turned_stress(R) * r.rows * T.transpose()).eval();
  }
  for (LoadVector& load : instance.loads) load.force = (T * load.force).eval();
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

Eigen::VectorXd effective_interface_mass(const Superelement& s) {
  const Eigen::Index n = s.boundary();
  const Eigen::VectorXd total = s.M.diagonal().head(n);
  return (total.cwiseInverse().asDiagonal() * s.M.topRightCorner(n, s.modal()).cwiseAbs2())
      .colwise()
      .mean()
      .transpose();
}

Reduction with_modes(const Reduction& reduction, const std::vector<int>& kept) {
  Reduction r = reduction;
  Superelement& s = r.element;
  const int all = static_cast<int>(s.K.rows());
  std::vector<int> rows(s.boundary());
  std::iota(rows.begin(), rows.end(), 0);
  for (int j : kept) rows.push_back(s.boundary() + j);
  for (MatrixXd* A : {&s.K, &s.M, &s.C, &s.D})
    if (A->size() > 0) *A = MatrixXd((*A)(rows, rows));
  for (RecoveryRows& x : s.recovery) x.rows = MatrixXd(x.rows(Eigen::all, rows));
  for (StressRows& x : s.stresses) x.rows = MatrixXd(x.rows(Eigen::all, rows));
  for (LoadVector& x : s.loads) x.force = Eigen::VectorXd(x.force(rows));
  r.lambda = Eigen::VectorXd(reduction.lambda(kept));
  const auto spread = [rows, all](const MatrixXd& c) {
    MatrixXd full = MatrixXd::Zero(all, c.cols());
    full(rows, Eigen::all) = c;
    return full;
  };
  r.field = [field = reduction.field, spread](const MatrixXd& c) { return field(spread(c)); };
  r.field_at = [field = reduction.field_at, spread](const MatrixXd& c,
                                                    const std::vector<int>& nodes) {
    return field(spread(c), nodes);
  };
  return r;
}

} // namespace plica

// The reduced model of changed structures, by their common basis.
#include "reduction/parametric_model.hpp"

#include "solve/dense_modes.hpp"
#include "solve/dense_product.hpp"
#include "solve/model_error.hpp"
#include "solve/parallel.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Rows of a matrix over all independent DOFs that belong to those of a change.
MatrixXd rows_at(const MatrixXd& all, const std::vector<int>& dofs) {
  return Index(dofs.size()) == all.rows() ? all : MatrixXd(all(dofs, Eigen::all));
}

// V' K_0 X for the columns X that changes add.
MatrixXd work(const MatrixXd& V, const std::vector<PreparedChange>& changes, Index columns) {
  MatrixXd all(V.cols(), columns);
  Index at = 0;
  for (const PreparedChange& change : changes) {
    const Index own = change.forces.cols();
    if (change.forces.rows() == V.rows())
      all.middleCols(at, own) = transposed_product(V, change.forces);
    else
      all.middleCols(at, own) =
          transposed_product(MatrixXd(V(change.dofs, Eigen::all)), change.forces);
    at += own;
  }
  return all;
}

template <class OfPsi, class OfW, class OfX>
MatrixXd side_by_side(const OfPsi& of_Psi, const OfW& of_W, const OfX& of_X) {
  MatrixXd rows(of_Psi.rows(), of_Psi.cols() + of_W.cols() + of_X.cols());
  rows << of_Psi, of_W, of_X;
  return rows;
}

// Rows over [Psi | W | X] to those over q.
MatrixXd over_q(const MatrixXd& rows, const MatrixXd& T) {
  const Index n = T.rows(), b = rows.cols() - n;
  MatrixXd own(rows.rows(), b + T.cols());
  own << rows.leftCols(b), product(rows.rightCols(n), T);
  return own;
}

MatrixXd seen_by(const SparseMatrix& A, const MatrixXd& V) { // V' A V
  if (A.nonZeros() == 0) return MatrixXd::Zero(V.cols(), V.cols());
  return transposed_product(V, symmetric_product(A, V));
}

// Forces of what acts on a motion that is a sum of terms, the first of them among the changes
// given: on columns of u, each times its scale.
void add_forces(const std::vector<PreparedChange>& changes, Index first, const VectorXd& c,
                const MatrixXd& u, const VectorXd& scale, MatrixXd& forces) {
  Eigen::RowVectorXd moved = Eigen::RowVectorXd::Zero(u.cols());
  const auto each = [&](const auto& act) {
    for (Index k = 0; k < c.size(); ++k) {
      const PreparedChange& d = changes[std::size_t(first + k)];
      for (std::size_t j = 0; j < d.dofs.size(); ++j) act(d.dofs[j], c[k] * d.factors[Index(j)]);
    }
  };
  each([&](int dof, double factor) { moved += factor * u.row(dof); });
  moved = moved.cwiseProduct(scale.transpose());
  each([&](int dof, double factor) { forces.row(dof) += factor * moved; });
}

// Force per motion of what acts on a motion, its coefficients those of one, at each lambda. The
// mass of a resonator moves by w^2 / (w^2 - lambda) of the motion that it hangs on.
VectorXd resistance(const MotionSum& sum, const VectorXd& coefficients, const VectorXd& lambda) {
  switch (sum.of) {
  case MotionTerm::Of::spring:
    return VectorXd::Ones(lambda.size());
  case MotionTerm::Of::mass:
    return -lambda;
  case MotionTerm::Of::resonator:
    break;
  }
  const double own = std::pow(sum.frequency(coefficients), 2);
  return (-lambda.array() / (own - lambda.array())).matrix();
}

} // namespace

ParametricModel::Basis ParametricModel::basis_of(const std::vector<PreparedChange>& changes) const {
  Index further = 0;
  for (const PreparedChange& change : changes) further += change.further.cols();
  MatrixXd X(system_.map.size(), further);
  Index at = 0;
  for (const PreparedChange& change : changes) {
    X.middleCols(at, change.further.cols()) = change.further;
    at += change.further.cols();
  }
  // What the changes add to the basis, free of what it has.
  MatrixXd XKX(further, further);
  if (further > 0) {
    const VectorXd before = work(X, changes, further).diagonal();
    const MatrixXd part = WKW_.ldlt().solve(work(W_, changes, further));
    subtract_product(X, W_, part);
    XKX = work(X, changes, further) - transposed_product(X, KW_) * part;
    constexpr double rounding = 1e-10; // of the energy: the basis had it all
    std::vector<Index> news;
    for (Index j = 0; j < further; ++j)
      if (XKX(j, j) > rounding * before[j]) news.push_back(j);
    if (Index(news.size()) < further) {
      X = MatrixXd(X(Eigen::all, news));
      XKX = MatrixXd(XKX(news, news));
    }
  }
  const Index c = W_.cols(), n = c + X.cols();
  MatrixXd E = MatrixXd::Zero(n, n);
  E.topLeftCorner(c, c) = WKW_;
  E.bottomRightCorner(X.cols(), X.cols()) = (XKX + XKX.transpose()) / 2;
  // Columns of unit energy, those that add none dropped.
  const VectorXd size = E.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> gram(
      MatrixXd(size.asDiagonal() * E * size.asDiagonal()));
  constexpr double negligible = 1e-9;
  std::vector<Index> kept;
  for (Index j = 0; j < n; ++j)
    if (gram.eigenvalues()[j] > negligible * gram.eigenvalues().maxCoeff()) kept.push_back(j);
  const VectorXd scale = gram.eigenvalues()(kept).cwiseSqrt().cwiseInverse();
  MatrixXd T = size.asDiagonal() * gram.eigenvectors()(Eigen::all, kept) * scale.asDiagonal();
  return {std::move(X), std::move(E), std::move(T)};
}

AffineModel ParametricModel::with(const std::vector<PreparedChange>& changes) const {
  return reduced(changes, basis_of(changes));
}

ParametricModel::InnerMass ParametricModel::inner_mass(const MatrixXd& X) const {
  const Index c = W_.cols(), n = c + X.cols();
  const MatrixXd MX = symmetric_product(system_.M, X);
  InnerMass mass{.own = MatrixXd(n, n), .to_boundary = MatrixXd(Psi_.cols(), n)};
  MatrixXd& G = mass.own;
  G.topLeftCorner(c, c) = WMW_;
  G.topRightCorner(c, X.cols()) = transposed_product(MW_, X);
  G.bottomLeftCorner(X.cols(), c) = G.topRightCorner(c, X.cols()).transpose();
  G.bottomRightCorner(X.cols(), X.cols()) = transposed_product(X, MX);
  mass.to_boundary << PsiMW_, transposed_product(MPsi_, X);
  return mass;
}

void ParametricModel::add_changes(const std::vector<PreparedChange>& changes, const Basis& basis,
                                  AffineModel& affine) const {
  const MatrixXd &X = basis.X, &T = basis.T;
  MatrixXd all; // of what reaches everywhere
  const auto is_whole = [&](const PreparedChange& d) { return Index(d.dofs.size()) == X.rows(); };
  if (std::any_of(changes.begin(), changes.end(), is_whole))
    all = over_q(side_by_side(Psi_, W_, X), T);
  for (const PreparedChange& change : changes)
    if (change.product_of) affine.products.push_back(*change.product_of);
  affine.dK.resize(changes.size());
  affine.dM.resize(changes.size());
  affine.d_load.resize(changes.size());
  affine.d_mass.resize(changes.size());
  in_parallel(int(changes.size()), [&](int i) {
    const PreparedChange& d = changes[std::size_t(i)];
    if (d.term) return;
    const bool whole = is_whole(d);
    const MatrixXd own = whole ? MatrixXd()
                               : over_q(side_by_side(Psi_(d.dofs, Eigen::all),
                                                     W_(d.dofs, Eigen::all), X(d.dofs, Eigen::all)),
                                        T);
    const MatrixXd& V = whole ? all : own;
    const MatrixXd r = rows_at(rigid_, d.dofs).leftCols(3), Mr = symmetric_product(d.M, r);
    affine.dK[std::size_t(i)] = seen_by(d.K, V);
    affine.dM[std::size_t(i)] = seen_by(d.M, V);
    affine.d_load[std::size_t(i)] = V.transpose() * Mr;
    affine.d_mass[std::size_t(i)] = r.col(affine.weighed_along).dot(Mr.col(affine.weighed_along));
  });
  add_sums(changes, basis, affine);
}

void ParametricModel::add_sums(const std::vector<PreparedChange>& changes, const Basis& basis,
                               AffineModel& affine) const {
  for (std::size_t i = 0; i < changes.size();) {
    if (!changes[i].term) {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    while (end < changes.size() && changes[end].term && !changes[end].term->begins) ++end;
    const auto count = Index(end - i);
    MotionSum sum{.of = changes[i].term->of,
                  .first = Index(i),
                  .rows = MatrixXd::Zero(count, Psi_.cols() + W_.cols() + basis.X.cols()),
                  .rigid = MatrixXd::Zero(count, 3)};
    for (Index k = 0; k < count; ++k) {
      const PreparedChange& d = changes[i + std::size_t(k)];
      for (std::size_t j = 0; j < d.dofs.size(); ++j) {
        const int dof = d.dofs[j];
        const double factor = d.factors[Index(j)];
        sum.rows.row(k) += factor * side_by_side(Psi_.row(dof), W_.row(dof), basis.X.row(dof));
        sum.rigid.row(k) += factor * rigid_.row(dof).head<3>();
      }
    }
    sum.rows = over_q(sum.rows, basis.T);
    affine.sums.push_back(std::move(sum));
    i = end;
  }
}

MatrixXd ParametricModel::nominal_over_q(const InnerMass& mass, const MatrixXd& T,
                                         const MatrixXd& M) const {
  const Index modes = nominal_.lambda.size(), k = T.cols();
  MatrixXd q = MatrixXd::Zero(M.rows(), modes);
  if (modes == 0) return q; // they are about to be found
  const MatrixXd inner = T.transpose() * (mass.own.leftCols(W_.cols()) * nominal_.inside +
                                          mass.to_boundary.transpose() * nominal_.boundary);
  if (nominal_.boundary.isZero(0)) {
    q.bottomRows(k) = MatrixXd(M.bottomRightCorner(k, k)).ldlt().solve(inner);
    return q;
  }
  MatrixXd momentum(M.rows(), modes);
  momentum << PsiMPsi_ * nominal_.boundary + PsiMW_ * nominal_.inside, inner;
  return M.ldlt().solve(momentum);
}

AffineModel ParametricModel::reduced(const std::vector<PreparedChange>& changes,
                                     const Basis& basis) const {
  const MatrixXd &X = basis.X, &T = basis.T;
  const Index b = Psi_.cols(), k = T.cols();
  const InnerMass mass = inner_mass(X);
  AffineModel affine;
  affine.boundary = int(b);
  affine.lambda = nominal_.lambda;
  affine.K = MatrixXd::Zero(b + k, b + k);
  affine.K.topLeftCorner(b, b) = PsiKPsi_;
  affine.K.bottomRightCorner(k, k) = T.transpose() * basis.E * T;
  affine.M.resize(b + k, b + k);
  affine.M.topLeftCorner(b, b) = PsiMPsi_;
  affine.M.topRightCorner(b, k) = mass.to_boundary * T;
  affine.M.bottomLeftCorner(k, b) = affine.M.topRightCorner(b, k).transpose();
  affine.M.bottomRightCorner(k, k) = T.transpose() * mass.own * T;
  const MatrixXd rigid =
      over_q(side_by_side(rigidMPsi_, rigidMW_, transposed_product(Mr_, X)), T).transpose();
  affine.suspension = {.leaves_rigid = nominal_.suspended,
                       .shift = nominal_.suspended ? small_shift * nominal_.lambda[0] : 0,
                       .rigid = rigid * loose_,
                       .rigid_mass = loose_mass()};
  affine.load = rigid.leftCols(3);
  // What changes is weighed along the axis that supports hold least of it.
  rigid_.cwiseProduct(Mr_).leftCols(3).colwise().sum().maxCoeff(&affine.weighed_along);
  affine.mass = mass_;
  affine.marked = over_q(side_by_side(markedPsi_, markedW_, MatrixXd(markers_ * X)), T);
  add_changes(changes, basis, affine);
  affine.nominal = nominal_over_q(mass, T, affine.M);
  affine.hang_resonators();
  return affine;
}

VectorXd ParametricModel::frequency_errors(const std::vector<PreparedChange>& changes,
                                           const VectorXd& of_changes, const std::vector<int>& free,
                                           int modes) const {
  const Basis basis = basis_of(changes);
  const AffineModel f = reduced(changes, basis);
  const MatrixXd K = f.stiffness(of_changes), M = f.mass_matrix(of_changes);
  Suspension suspension = f.suspension;
  suspension.rigid = suspension.rigid(free, Eigen::all).eval();
  const auto lowest =
      reduced_modes(K(free, free), M(free, free), suspension, Index(modes) + rigid_modes);
  if (!lowest) return VectorXd::Constant(modes, std::numeric_limits<double>::quiet_NaN());
  const Index count = std::min<Index>(modes, lowest->lambda.size());
  const VectorXd lambda = lowest->lambda.head(count);
  MatrixXd q = MatrixXd::Zero(K.rows(), count);
  q(free, Eigen::all) = lowest->q.leftCols(count);
  const MatrixXd inner = basis.T * q.middleRows(Psi_.cols(), basis.T.cols());
  const MatrixXd u = Psi_ * q.topRows(Psi_.cols()) + W_ * inner.topRows(W_.cols()) +
                     basis.X * inner.bottomRows(basis.X.cols());
  MatrixXd r =
      symmetric_product(system_.K, u) - symmetric_product(system_.M, u) * lambda.asDiagonal();
  const VectorXd coefficients = with_products(of_changes, f.products);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const PreparedChange& d = changes[i];
    if (d.term) continue;
    const MatrixXd own = u(d.dofs, Eigen::all);
    const MatrixXd force =
        symmetric_product(d.K, own) - symmetric_product(d.M, own * lambda.asDiagonal());
    r(d.dofs, Eigen::all) += coefficients[Index(i)] * force;
  }
  for (const MotionSum& sum : f.sums)
    add_forces(changes, sum.first, sum.coefficients_of(of_changes), u,
               resistance(sum, of_changes, lambda), r);
  for (int dof : held_) r.row(dof).setZero();
  const VectorXd energy = r.cwiseProduct(solve_inside(r)).colwise().sum();
  return (energy.array() / (2 * lambda.array())).matrix();
}

} // namespace plica

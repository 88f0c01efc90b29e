#include "reduction/parametric_model.hpp"

#include "solve/dense_modes.hpp"
#include "solve/dense_product.hpp"
#include "solve/mode_labels.hpp"
#include "solve/model_error.hpp"
#include "solve/parallel.hpp"
#include "solve/statics.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Columns that span the same space, those that add nothing dropped.
MatrixXd independent_columns(const MatrixXd& A, double tolerance) {
  if (A.cols() == 0 || A.norm() == 0) return MatrixXd(A.rows(), 0);
  MatrixXd scaled = A;
  std::vector<Index> kept;
  for (Index j = 0; j < A.cols(); ++j)
    if (const double size = scaled.col(j).norm(); size > 1e-12 * A.colwise().norm().maxCoeff()) {
      scaled.col(j) /= size;
      kept.push_back(j);
    }
  const MatrixXd used = scaled(Eigen::all, kept);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> gram(MatrixXd(used.transpose() * used));
  const double least = tolerance * gram.eigenvalues().maxCoeff();
  std::vector<Index> large;
  for (Index j = 0; j < gram.eigenvalues().size(); ++j)
    if (gram.eigenvalues()[j] > least) large.push_back(j);
  const VectorXd scale = gram.eigenvalues()(large).cwiseSqrt().cwiseInverse();
  return used * (gram.eigenvectors()(Eigen::all, large) * scale.asDiagonal());
}

void append_columns(MatrixXd& A, const MatrixXd& more) {
  const Index own = A.cols();
  A.conservativeResize(Eigen::NoChange, own + more.cols());
  A.rightCols(more.cols()) = more;
}

MatrixXd unit_columns(Index rows, const std::vector<int>& at) {
  MatrixXd E = MatrixXd::Zero(rows, Index(at.size()));
  for (std::size_t j = 0; j < at.size(); ++j) E(at[j], Index(j)) = 1;
  return E;
}

// Lanczos cannot give all; the dense solver can.
int most_modes(const SparseMatrix& K, const SparseMatrix& M) {
  return better_dense(K, M) ? int(K.rows()) : std::max(1, int(K.rows()) - 1);
}

constexpr int followed = 6; // modes whose change the basis follows

} // namespace

ParametricModel::ParametricModel(Model model, std::vector<int> boundary, std::vector<int> marked,
                                 int modes, const std::vector<int>& observed)
    : model_(std::move(model)), boundary_(std::move(boundary)), marked_(std::move(marked)),
      count_(modes), system_(assemble(model_)) {
  const DofMap& map = system_.map;
  for (int node : boundary_)
    for (int dof = 6 * node; dof < 6 * node + 6; ++dof) {
      if (map.independent[dof] < 0)
        throw ModelError("a mount or cap whose motion other constraints determine");
      held_.push_back(map.independent[dof]);
    }
  std::vector<int> sorted = held_;
  std::sort(sorted.begin(), sorted.end());
  inside_ = complement(map.size(), sorted);
  row_inside_.assign(std::size_t(map.size()), -1);
  for (std::size_t i = 0; i < inside_.size(); ++i) row_inside_[std::size_t(inside_[i])] = int(i);
  const SparseMatrix K = restrict_to(system_.K, inside_), M = restrict_to(system_.M, inside_);
  BaseFactor base = factor_below_spectrum(K, M);
  if (base.sigma < 0) throw ModelError("nothing holds the part: hold it by a mount or supports");
  const ModeSet set = find_modes(
      K, M, {.count = std::min(count_, most_modes(K, M)), .band = {}, .proof = false}, base);
  lambda_ = set.lambda;
  MatrixXd Phi = inner_columns(set.Phi), u = expand(map, Phi);
  orient_modes(model_, marked_, lambda_, Phi, u);
  factor_.emplace(std::move(base.factor));
  Psi_ = constraint_modes(system_.K, *factor_);

  std::vector<int> seen = marked_;
  seen.insert(seen.end(), observed.begin(), observed.end());
  std::vector<Eigen::Triplet<double>> marks;
  for (std::size_t i = 0; i < seen.size(); ++i)
    for (int d = 0; d < 6; ++d) {
      const int dof = 6 * seen[i] + d, row = 6 * int(i) + d;
      if (map.independent[dof] >= 0) marks.emplace_back(row, map.independent[dof], 1);
      for (const WeightedDof& w : map.dependent[dof]) marks.emplace_back(row, w.dof, w.factor);
    }
  markers_.resize(6 * Index(seen.size()), map.size());
  markers_.setFromTriplets(marks.begin(), marks.end());
  MatrixXd pulls = MatrixXd::Zero(map.size(), 3 * Index(marked_.size()));
  for (std::size_t i = 0; i < marked_.size(); ++i)
    for (int d = 0; d < 3; ++d) {
      const Index row = 6 * Index(i) + d;
      for (int k = 0; k < markers_.outerSize(); ++k)
        for (Eigen::SparseMatrix<double>::InnerIterator it(markers_, k); it; ++it)
          if (it.row() == row) pulls(k, 3 * Index(i) + d) = it.value();
    }
  const MatrixXd attachments = solve_inside(pulls);
  W_.resize(map.size(), Phi.cols() + attachments.cols());
  W_ << Phi, attachments;
  KW_ = symmetric_product(system_.K, W_);
  MW_ = symmetric_product(system_.M, W_);
  MPsi_ = symmetric_product(system_.M, Psi_);
  PsiKPsi_ = Psi_.transpose() * symmetric_product(system_.K, Psi_);
  PsiMPsi_ = Psi_.transpose() * MPsi_;
  WKW_ = W_.transpose() * KW_;
  WMW_ = W_.transpose() * MW_;
  PsiMW_ = Psi_.transpose() * MW_;
  rigid_ = rigid_body_motions(model_, map, {0, 0, 0}).leftCols(3);
  Mr_ = symmetric_product(system_.M, rigid_);
  rigidMPsi_ = Mr_.transpose() * Psi_;
  rigidMW_ = Mr_.transpose() * W_;
  markedPsi_ = markers_ * Psi_;
  markedW_ = markers_ * W_;
}

MatrixXd ParametricModel::nominal_shapes() const {
  return expand(system_.map, W_.leftCols(lambda_.size()));
}

MatrixXd ParametricModel::basis() const {
  const MatrixXd own = W_ * basis_of({}).T;
  MatrixXd V(Psi_.rows(), Psi_.cols() + own.cols());
  V << Psi_, own;
  return expand(system_.map, V);
}

MatrixXd ParametricModel::inner_columns(const MatrixXd& inside) const {
  MatrixXd all = MatrixXd::Zero(system_.map.size(), inside.cols());
  all(inside_, Eigen::all) = inside;
  return all;
}

MatrixXd ParametricModel::solve_inside(const MatrixXd& force) const {
  if (force.cols() == 0) return MatrixXd(system_.map.size(), 0);
  return inner_columns(factor_->solve(force(inside_, Eigen::all)));
}

MatrixXd ParametricModel::constraint_modes(const SparseMatrix& K,
                                           const SparseFactor& inside) const {
  MatrixXd Psi = unit_columns(system_.map.size(), held_);
  if (held_.empty()) return Psi;
  const MatrixXd force = symmetric_product(K, Psi)(inside_, Eigen::all);
  Psi -= inner_columns(inside.solve(force));
  return Psi;
}

// Answers to forces on the DOFs of changes, the boundary held: all solved for at once, as the
// factor is read once for all columns.
std::vector<MatrixXd> ParametricModel::answers(const std::vector<Loaded>& loads) const {
  Index columns = 0;
  for (const Loaded& load : loads) columns += load.forces.cols();
  MatrixXd f = MatrixXd::Zero(Index(inside_.size()), columns);
  Index at = 0;
  for (const Loaded& load : loads) {
    for (std::size_t i = 0; i < load.dofs->size(); ++i)
      if (const int row = row_inside_[std::size_t((*load.dofs)[i])]; row >= 0)
        f.row(row).segment(at, load.forces.cols()) = load.forces.row(Index(i));
    at += load.forces.cols();
  }
  if (columns > 0) f = factor_->solve(f);
  std::vector<MatrixXd> found;
  at = 0;
  for (const Loaded& load : loads) {
    found.push_back(inner_columns(f.middleCols(at, load.forces.cols())));
    at += load.forces.cols();
  }
  return found;
}

// First terms of the Neumann series of modes and constraint modes. Forces of few directions, as
// those of a spring or a mass are, need few solutions, and no second term: it is in the first.
void ParametricModel::follow_series(const std::vector<PreparedChange*>& changes) const {
  const Index modes = std::min<Index>(followed, lambda_.size());
  std::vector<Loaded> first, second;
  std::vector<std::size_t> of_second;
  for (const PreparedChange* change : changes) {
    const MatrixXd Phi = W_(change->dofs, Eigen::seqN(0, modes)),
                   Psi = Psi_(change->dofs, Eigen::all);
    MatrixXd f(Index(change->dofs.size()), 2 * modes + Psi.cols());
    f << symmetric_product(change->K, Phi), symmetric_product(change->M, Phi),
        symmetric_product(change->K, Psi);
    constexpr double negligible = 1e-8;
    first.push_back({&change->dofs, independent_columns(f, negligible)});
  }
  std::vector<MatrixXd> to_first = answers(first);
  for (std::size_t i = 0; i < changes.size(); ++i)
    if (first[i].forces.cols() > modes) {
      const std::vector<int>& dofs = changes[i]->dofs;
      second.push_back(
          {&dofs, symmetric_product(changes[i]->K, to_first[i](dofs, Eigen::seqN(0, modes)))});
      of_second.push_back(i);
    }
  const std::vector<MatrixXd> to_second = answers(second);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    changes[i]->further = std::move(to_first[i]);
    changes[i]->forces = std::move(first[i].forces);
  }
  for (std::size_t k = 0; k < second.size(); ++k) {
    append_columns(changes[of_second[k]]->further, to_second[k]);
    append_columns(changes[of_second[k]]->forces, second[k].forces);
  }
  for (PreparedChange* change : changes)
    for (std::size_t i = 0; i < change->dofs.size(); ++i)
      if (row_inside_[std::size_t(change->dofs[i])] < 0) change->forces.row(Index(i)).setZero();
}

// The lowest modes of the changed structure, as far as two steps of subspace iteration from the
// nominal ones bring them, and what its constraint modes differ by.
void ParametricModel::follow_modes(PreparedChange& change) const {
  SparseMatrix K = system_.K, M = system_.M;
  for (const auto& [from, to] : {std::pair{&change.K, &K}, {&change.M, &M}})
    for (int j = 0; j < from->outerSize(); ++j)
      for (SparseMatrix::InnerIterator it(*from, j); it; ++it)
        to->coeffRef(change.dofs[std::size_t(it.row())], change.dofs[std::size_t(j)]) += it.value();
  const SparseMatrix M_inside = restrict_to(M, inside_);
  const SparseMatrix K_inside = restrict_to(K, inside_);
  const BaseFactor base = factor_below_spectrum(K_inside, M_inside);
  constexpr int steps = 2, count = 12;
  MatrixXd V = W_(inside_, Eigen::seqN(0, lambda_.size()));
  for (int step = 0; step < steps; ++step) {
    V = base.factor.solve(symmetric_product(M_inside, V));
    V.colwise().normalize();
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> ritz(
      V.transpose() * symmetric_product(K_inside, V),
      V.transpose() * symmetric_product(M_inside, V));
  const Index kept = std::min<Index>(count, V.cols());
  change.further.resize(system_.map.size(), kept + Psi_.cols());
  change.further << inner_columns(V * ritz.eigenvectors().leftCols(kept)),
      constraint_modes(K, base.factor) - Psi_;
  change.forces = symmetric_product(system_.K, change.further);
  for (int dof : held_) change.forces.row(dof).setZero();
}

PreparedChange ParametricModel::prepare(const ModelChange& change) const {
  return std::move(prepare(std::vector{change}).front());
}

std::vector<PreparedChange>
ParametricModel::prepare(const std::vector<ModelChange>& changes) const {
  std::vector<PreparedChange> made;
  for (const ModelChange& change : changes) {
    Model changed = model_;
    if (change.apply) change.apply(changed);
    MatrixDifference difference = matrix_difference(changed, model_, system_, change.on_mean);
    const auto own = Index(difference.dofs.size());
    made.push_back({std::move(difference), MatrixXd(system_.map.size(), 0), MatrixXd(own, 0)});
  }
  std::vector<PreparedChange*> series;
  for (std::size_t i = 0; i < made.size(); ++i) {
    if (made[i].dofs.empty()) continue;
    if (changes[i].follow == Follow::series) series.push_back(&made[i]);
    if (changes[i].follow == Follow::modes) follow_modes(made[i]);
  }
  follow_series(series);
  return made;
}

namespace {

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

ReducedFamily ParametricModel::with(const std::vector<PreparedChange>& changes) const {
  return reduced(changes, basis_of(changes));
}

ReducedFamily ParametricModel::reduced(const std::vector<PreparedChange>& changes,
                                       const Basis& basis) const {
  const MatrixXd &X = basis.X, &T = basis.T, &E = basis.E;
  const Index c = W_.cols(), n = c + X.cols(), b = Psi_.cols();
  const MatrixXd MX = symmetric_product(system_.M, X);
  MatrixXd G(n, n), P(b, n);
  G.topLeftCorner(c, c) = WMW_;
  G.topRightCorner(c, X.cols()) = transposed_product(MW_, X);
  G.bottomLeftCorner(X.cols(), c) = G.topRightCorner(c, X.cols()).transpose();
  G.bottomRightCorner(X.cols(), X.cols()) = transposed_product(X, MX);
  P << PsiMW_, transposed_product(MPsi_, X);
  const Index k = T.cols();
  ReducedFamily family;
  family.boundary = int(b);
  family.lambda = lambda_;
  family.K = MatrixXd::Zero(b + k, b + k);
  family.K.topLeftCorner(b, b) = PsiKPsi_;
  family.K.bottomRightCorner(k, k) = T.transpose() * E * T;
  family.M.resize(b + k, b + k);
  family.M.topLeftCorner(b, b) = PsiMPsi_;
  family.M.topRightCorner(b, k) = P * T;
  family.M.bottomLeftCorner(k, b) = family.M.topRightCorner(b, k).transpose();
  family.M.bottomRightCorner(k, k) = T.transpose() * G * T;
  // Rows over [Psi | W | X] to those over q.
  const auto over_q = [&](const MatrixXd& rows) {
    MatrixXd own(rows.rows(), b + k);
    own << rows.leftCols(b), rows.rightCols(n) * T;
    return own;
  };
  const auto over_q_both = [&](const MatrixXd& square) -> MatrixXd {
    return over_q(over_q(square).transpose()).transpose();
  };
  const auto seen_by = [&](const SparseMatrix& A, const MatrixXd& V) -> MatrixXd { // V' A V
    if (A.nonZeros() == 0) return MatrixXd::Zero(b + k, b + k);
    return over_q_both(transposed_product(V, symmetric_product(A, V)));
  };
  const auto side_by_side = [&](const auto& of_Psi, const auto& of_W, const auto& of_X) {
    MatrixXd rows(of_Psi.rows(), b + n);
    rows << of_Psi, of_W, of_X;
    return rows;
  };
  family.load = over_q(side_by_side(rigidMPsi_, rigidMW_, transposed_product(Mr_, X))).transpose();
  family.mass = rigid_.col(1).dot(Mr_.col(1));
  family.marked = over_q(side_by_side(markedPsi_, markedW_, MatrixXd(markers_ * X)));
  MatrixXd all; // of what reaches everywhere
  const auto is_whole = [&](const PreparedChange& d) { return Index(d.dofs.size()) == X.rows(); };
  if (std::any_of(changes.begin(), changes.end(), is_whole)) all = side_by_side(Psi_, W_, X);
  family.dK.resize(changes.size());
  family.dM.resize(changes.size());
  family.d_load.resize(changes.size());
  family.d_mass.resize(changes.size());
  in_parallel(int(changes.size()), [&](int i) {
    const PreparedChange& d = changes[std::size_t(i)];
    const bool whole = is_whole(d);
    const MatrixXd own = whole ? MatrixXd()
                               : side_by_side(Psi_(d.dofs, Eigen::all), W_(d.dofs, Eigen::all),
                                              X(d.dofs, Eigen::all));
    const MatrixXd& V = whole ? all : own;
    const MatrixXd r = rows_at(rigid_, d.dofs), Mr = symmetric_product(d.M, r);
    family.dK[std::size_t(i)] = seen_by(d.K, V);
    family.dM[std::size_t(i)] = seen_by(d.M, V);
    family.d_load[std::size_t(i)] = over_q(Mr.transpose() * V).transpose();
    family.d_mass[std::size_t(i)] = r.col(1).dot(Mr.col(1));
  });
  family.nominal = MatrixXd::Zero(b + k, lambda_.size());
  family.nominal.bottomRows(k) = MatrixXd(family.M.bottomRightCorner(k, k))
                                     .ldlt()
                                     .solve(MatrixXd(T.transpose() * G.leftCols(lambda_.size())));
  return family;
}

VectorXd ParametricModel::frequency_errors(const std::vector<PreparedChange>& changes,
                                           const VectorXd& coefficients,
                                           const std::vector<int>& free, int modes) const {
  const Basis basis = basis_of(changes);
  const ReducedFamily f = reduced(changes, basis);
  MatrixXd K = f.K, M = f.M;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    K += coefficients[Index(i)] * f.dK[i];
    M += coefficients[Index(i)] * f.dM[i];
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> pairs(K(free, free), M(free, free));
  if (pairs.info() != Eigen::Success || !(pairs.eigenvalues()[0] > 0))
    throw ModelError("the changed structure is not stable");
  const Index count = std::min<Index>(modes, pairs.eigenvalues().size());
  const VectorXd lambda = pairs.eigenvalues().head(count);
  MatrixXd q = MatrixXd::Zero(K.rows(), count);
  q(free, Eigen::all) = pairs.eigenvectors().leftCols(count);
  const MatrixXd inner = basis.T * q.bottomRows(basis.T.cols());
  const MatrixXd u = Psi_ * q.topRows(Psi_.cols()) + W_ * inner.topRows(W_.cols()) +
                     basis.X * inner.bottomRows(basis.X.cols());
  MatrixXd r =
      symmetric_product(system_.K, u) - symmetric_product(system_.M, u) * lambda.asDiagonal();
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const PreparedChange& d = changes[i];
    const MatrixXd own = u(d.dofs, Eigen::all);
    const MatrixXd force =
        symmetric_product(d.K, own) - symmetric_product(d.M, own * lambda.asDiagonal());
    r(d.dofs, Eigen::all) += coefficients[Index(i)] * force;
  }
  for (int dof : held_) r.row(dof).setZero();
  const VectorXd energy = r.cwiseProduct(solve_inside(r)).colwise().sum();
  return (energy.array() / (2 * lambda.array())).matrix();
}

} // namespace plica

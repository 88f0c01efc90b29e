// How the basis of a parametric model follows its changes.
#include "reduction/parametric_model.hpp"

#include "solve/dense_modes.hpp"
#include "solve/dense_product.hpp"
#include "solve/model_error.hpp"
#include "solve/parallel.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <iterator>

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

PreparedChange prepared_term(const MotionTerm& term, const DofMap& map) {
  DofColumn column = dof_column(map, term.nodes, term.dof);
  const auto own = Index(column.dofs.size());
  PreparedChange made{{.K = SparseMatrix(int(own), int(own)),
                       .M = SparseMatrix(int(own), int(own)),
                       .dofs = std::move(column.dofs)},
                      MatrixXd(map.size(), 0),
                      MatrixXd(own, 0)};
  made.term = term;
  made.factors = std::move(column.factors);
  return made;
}

constexpr int followed = 6; // modes whose change the basis follows

} // namespace

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
  constexpr double negligible = 1e-8;
  for (const PreparedChange* change : changes) {
    if (change->term) {
      first.push_back({&change->dofs, change->factors});
      continue;
    }
    const MatrixXd Phi = W_(change->dofs, Eigen::seqN(0, modes)),
                   Psi = Psi_(change->dofs, Eigen::all);
    MatrixXd f(Index(change->dofs.size()), 2 * modes + Psi.cols());
    f << symmetric_product(change->K, Phi), symmetric_product(change->M, Phi),
        symmetric_product(change->K, Psi);
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
    if (change.term) {
      made.push_back(prepared_term(*change.term, system_.map));
      continue;
    }
    Model changed = model_;
    if (change.apply) change.apply(changed);
    MatrixDifference difference = matrix_difference(changed, model_, system_, change.on_motion);
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

std::optional<PreparedChange> ParametricModel::product(const ModelChange& both,
                                                       const PreparedChange& a,
                                                       const PreparedChange& b) const {
  const bool in_stiffness = a.K.nonZeros() > 0 && b.K.nonZeros() > 0,
             in_mass = a.M.nonZeros() > 0 && b.M.nonZeros() > 0;
  std::vector<int> common;
  std::set_intersection(a.dofs.begin(), a.dofs.end(), b.dofs.begin(), b.dofs.end(),
                        std::back_inserter(common));
  if (common.empty() || !(in_stiffness || in_mass)) return std::nullopt;
  Model changed = model_;
  both.apply(changed);
  MatrixDifference rest = difference_of(matrix_difference(changed, model_, system_, both.on_motion),
                                        a, b, system_.map.size());
  if (rest.dofs.empty()) return std::nullopt;
  const auto own = Index(rest.dofs.size());
  return PreparedChange{{std::move(rest)}, MatrixXd(system_.map.size(), 0), MatrixXd(own, 0)};
}

} // namespace plica

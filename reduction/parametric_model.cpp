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

MatrixXd unit_columns(Index rows, const std::vector<int>& at) {
  MatrixXd E = MatrixXd::Zero(rows, Index(at.size()));
  for (std::size_t j = 0; j < at.size(); ++j) E(at[j], Index(j)) = 1;
  return E;
}

// Lanczos cannot give all; the dense solver can.
int most_modes(const SparseMatrix& K, const SparseMatrix& M) {
  return better_dense(K, M) ? int(K.rows()) : std::max(1, int(K.rows()) - 1);
}

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

} // namespace plica

#include "reduction/parametric_model.hpp"

#include "solve/dense_modes.hpp"
#include "solve/dense_product.hpp"
#include "solve/effective_mass.hpp"
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

// Motions of nodes, six rows each, over the independent DOFs.
Eigen::SparseMatrix<double> motions_of(const std::vector<int>& nodes, const DofMap& map) {
  std::vector<Eigen::Triplet<double>> marks;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (int d = 0; d < 6; ++d) {
      const int dof = 6 * nodes[i] + d, row = 6 * int(i) + d;
      if (map.independent[dof] >= 0) marks.emplace_back(row, map.independent[dof], 1);
      for (const WeightedDof& w : map.dependent[dof]) marks.emplace_back(row, w.dof, w.factor);
    }
  Eigen::SparseMatrix<double> motions(6 * Index(nodes.size()), map.size());
  motions.setFromTriplets(marks.begin(), marks.end());
  return motions;
}

// Unit forces along x, y, z on the first of these nodes.
MatrixXd forces_on(Index nodes, const Eigen::SparseMatrix<double>& motions) {
  MatrixXd forces = MatrixXd::Zero(motions.cols(), 3 * nodes);
  for (Index i = 0; i < nodes; ++i)
    for (int d = 0; d < 3; ++d) {
      const Index row = 6 * i + d;
      for (int k = 0; k < motions.outerSize(); ++k)
        for (Eigen::SparseMatrix<double>::InnerIterator it(motions, k); it; ++it)
          if (it.row() == row) forces(k, 3 * i + d) = it.value();
    }
  return forces;
}

} // namespace

ParametricModel::ParametricModel(Model model, std::vector<int> boundary, std::vector<int> marked,
                                 int modes, const std::vector<int>& observed,
                                 const std::optional<std::vector<int>>& held, const MatrixXd& loose)
    : model_(std::move(model)), boundary_(std::move(boundary)), marked_(std::move(marked)),
      count_(modes), loose_(loose), system_(assemble(model_)) {
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
  markers_ = motions_of(seen, map);
  const MatrixXd attachments = solve_inside(forces_on(Index(marked_.size()), markers_));
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
  mass_ = total_mass(model_);
  rigid_ = rigid_body_motions(model_, map, {0, 0, 0});
  Mr_ = symmetric_product(system_.M, rigid_);
  rigidMPsi_ = Mr_.transpose() * Psi_;
  rigidMW_ = Mr_.transpose() * W_;
  markedPsi_ = markers_ * Psi_;
  markedW_ = markers_ * W_;
  nominal_ = held && *held != boundary_ ? modes_held_at(*held) : modes_inside();
}

namespace {

// Whether of modes of unit mass, by increasing frequency, all `rigid` motions come first and the
// next one lies far above.
bool hangs(Index rigid, const VectorXd& lambda, const VectorXd& rigid_shares) {
  constexpr double is_rigid = 0.9, far_above = 9; // of lambda: three times the frequency
  return rigid > 0 && lambda.size() > rigid && rigid_shares.head(rigid).minCoeff() > is_rigid &&
         lambda[rigid] > far_above * lambda[rigid - 1];
}

} // namespace

ParametricModel::NominalModes ParametricModel::modes_inside() const {
  const Index all = lambda_.size();
  const Suspension inside{.leaves_rigid = false,
                          .shift = 0,
                          .rigid = rigidMW_.transpose() * loose_,
                          .rigid_mass = loose_mass()};
  const bool suspended =
      hangs(loose_.cols(), lambda_, inside.rigid_shares(MatrixXd::Identity(W_.cols(), all)));
  const Index first = suspended ? loose_.cols() : 0;
  const Index count = all - first;
  NominalModes found{.lambda = lambda_.tail(count),
                     .boundary = MatrixXd::Zero(Psi_.cols(), count),
                     .inside = MatrixXd::Zero(W_.cols(), count),
                     .suspended = suspended,
                     .highest_rigid = first > 0 ? std::max(0., lambda_[first - 1]) : 0};
  found.inside.middleRows(first, count).setIdentity();
  return found;
}

// A shift makes the stiffness regular where nothing holds the structure.
ParametricModel::NominalModes ParametricModel::modes_held_at(const std::vector<int>& nodes) const {
  const Basis basis = basis_of({});
  const AffineModel f = reduced({}, basis);
  std::vector<int> free;
  for (Index i = 0; i < f.K.rows(); ++i)
    if (i >= f.boundary ||
        std::find(nodes.begin(), nodes.end(), boundary_[std::size_t(i / 6)]) == nodes.end())
      free.push_back(int(i));
  Suspension suspension = f.suspension;
  suspension.leaves_rigid = false; // whether it hangs is about to be found
  suspension.shift = small_shift * lambda_[0];
  suspension.rigid = suspension.rigid(free, Eigen::all).eval();
  const auto modes = reduced_modes(f.K(free, free), f.M(free, free), suspension, f.K.rows());
  if (!modes) throw ModelError("the structure is not stable");
  const bool suspended = hangs(loose_.cols(), modes->lambda, suspension.rigid_shares(modes->q));
  const Index first = suspended ? loose_.cols() : 0;
  const Index count = std::min<Index>(count_, modes->lambda.size() - first);
  MatrixXd own = MatrixXd::Zero(f.K.rows(), count);
  own(free, Eigen::all) = modes->q.middleCols(first, count);
  NominalModes found{.lambda = modes->lambda.segment(first, count),
                     .boundary = {},
                     .inside = {},
                     .suspended = suspended,
                     .highest_rigid = first > 0 ? std::max(0., modes->lambda[first - 1]) : 0};
  MatrixXd u = expand(system_.map, Psi_ * own.topRows(Psi_.cols()) +
                                       W_ * (basis.T * own.bottomRows(basis.T.cols())));
  orient_modes(model_, marked_, found.lambda, own, u);
  found.boundary = own.topRows(Psi_.cols());
  found.inside = basis.T * own.bottomRows(basis.T.cols());
  return found;
}

MatrixXd ParametricModel::loose_mass() const {
  return loose_.transpose() * (rigid_.transpose() * Mr_) * loose_;
}

MatrixXd ParametricModel::nominal_shapes() const {
  return expand(system_.map, Psi_ * nominal_.boundary + W_ * nominal_.inside);
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

#include "solve/block_lanczos.hpp"

#include "solve/dense_product.hpp"
#include "solve/shift_invert.hpp"

#include <algorithm>
#include <limits>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int block = 8;
constexpr double tolerance = 1e-8; // residual of a Ritz pair over its theta

// W = Q R with orthonormal Q, of as many columns as W has rank: by the eigenvalues of W' W, whose
// columns are scaled first (Stathopoulos & Wu, SIAM J. Sci. Comput. 23 (2002) 2165). The square
// loses half of the digits: once more makes Q orthonormal to all of them. `size` is what the
// columns were before they were made orthogonal to others: what is left of rounding is no
// direction.
struct Orthonormal {
  MatrixXd Q, R;
};

Orthonormal orthonormal(const MatrixXd& W, const VectorXd& size) {
  constexpr double nothing = 1e-14, dependent = 1e-14; // shares of a length, of a square
  VectorXd length = W.colwise().norm();
  length = (length.array() > nothing * size.array()).select(length, 0);
  const VectorXd scale = length.unaryExpr([](double l) { return l > 0 ? 1 / l : 0.; });
  const MatrixXd gram = scale.asDiagonal() * transposed_product(W, W) * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(symmetrised(gram));
  const auto rank = (eigen.eigenvalues().array() > dependent).count();
  const MatrixXd directions = eigen.eigenvectors().rightCols(rank);
  const VectorXd root = eigen.eigenvalues().tail(rank).cwiseSqrt();
  return {product(W, scale.asDiagonal() * directions * root.cwiseInverse().asDiagonal()),
          root.asDiagonal() * directions.transpose() * length.asDiagonal()};
}

class BlockLanczos {
public:
  BlockLanczos(const ShiftInvert& S, int count, int capacity, unsigned seed)
      : S_(S), count_(count), seed_(seed), V_(S.rows(), capacity),
        T_(MatrixXd::Zero(capacity, capacity)) {}

  // Until the pairs of largest theta have converged.
  void run() {
    constexpr int most_blocks = 5000;
    MatrixXd next = new_directions();
    for (int i = 0; i < most_blocks && next.cols() > 0 && !converged(); ++i) {
      append(next);
      next = step();
      if (next.cols() > 0 && size_ + next.cols() <= V_.cols() && size_ < next_look_) continue;
      look();
      if (next.cols() == 0) next = new_directions(); // the space is invariant
      if (!converged() && size_ + next.cols() > V_.cols()) restart();
    }
  }

  bool converged() const { return converged_ >= count_; }
  int converged_pairs() const { return converged_; }
  int operations() const { return operations_; }

  // The pairs of largest theta, at most those asked for, theta decreasing.
  VectorXd theta() const { return ritz_values_.head(found()); }
  MatrixXd vectors() const {
    return product(V_.leftCols(ritz_vectors_.rows()), ritz_vectors_.leftCols(found()));
  }

private:
  Index found() const { return std::min<Index>(count_, ritz_values_.size()); }

  // Orthonormal, and orthogonal to the basis; none where the basis is all there is.
  MatrixXd new_directions() {
    const auto columns = std::min<Index>(block, S_.rows() - size_);
    if (columns == 0) return {};
    MatrixXd W = S_.random_in_range(static_cast<int>(columns), seed_++);
    return outside(W).Q;
  }

  void append(const MatrixXd& next) {
    V_.middleCols(size_, next.cols()) = next;
    last_ = next.cols();
    size_ += last_;
  }

  // V' W, and W without it.
  MatrixXd project_out(MatrixXd& W) const {
    const MatrixXd H = transposed_product(V_.leftCols(size_), W);
    subtract_product(W, V_.leftCols(size_), H);
    return H;
  }

  // Q and R of what of W lies outside of the basis, and V' W. Twice: what the first time leaves
  // inside it grows as short directions are made unit ones.
  struct Outside {
    MatrixXd Q, R, H;
  };
  Outside outside(MatrixXd& W) const {
    const VectorXd size = W.colwise().norm();
    Outside o;
    o.H = project_out(W);
    Orthonormal first = orthonormal(W, size);
    o.H += project_out(first.Q) * first.R;
    Orthonormal second = orthonormal(first.Q, VectorXd::Ones(first.Q.cols()));
    o.Q = std::move(second.Q);
    o.R = second.R * first.R;
    return o;
  }

  // T for the last block; the next block.
  MatrixXd step() {
    MatrixXd W = S_ * MatrixXd(V_.middleCols(size_ - last_, last_));
    operations_ += static_cast<int>(last_);
    Outside next = outside(W);
    T_.block(0, size_ - last_, size_, last_) = next.H;
    T_.block(size_ - last_, 0, last_, size_) = next.H.transpose();
    remainder_ = std::move(next.R);
    return std::move(next.Q);
  }

  // Ritz pairs, and how many of the largest have converged.
  void look() {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(
        symmetrised(T_.topLeftCorner(size_, size_)));
    ritz_values_ = eigen.eigenvalues().reverse();
    ritz_vectors_ = eigen.eigenvectors().rowwise().reverse();
    constexpr double rounding = 10 * std::numeric_limits<double>::epsilon();
    converged_ = 0;
    for (; converged_ < found(); ++converged_) {
      const double theta = ritz_values_[converged_];
      const double residual = (remainder_ * ritz_vectors_.col(converged_).tail(last_)).norm();
      if (!(residual <= std::max(tolerance * theta, rounding * ritz_values_[0]))) break;
    }
    next_look_ = size_ + std::max<Index>(block, size_ / 16);
  }

  // The best Ritz vectors alone.
  void restart() {
    const Index kept = std::min<Index>(count_ + block, V_.cols() - 2 * block);
    V_.leftCols(kept) = product(V_.leftCols(size_), ritz_vectors_.leftCols(kept));
    T_.setZero();
    ritz_values_ = ritz_values_.head(kept).eval();
    ritz_vectors_ = MatrixXd::Identity(kept, kept);
    T_.diagonal().head(kept) = ritz_values_;
    size_ = kept;
    next_look_ = count_ + 2 * block;
  }

  const ShiftInvert& S_;
  int count_;
  unsigned seed_;
  MatrixXd V_, T_, remainder_; // R of the last block
  Index size_ = 0, last_ = 0;  // columns of V in use, those of the last block
  Index next_look_ = 0;        // at this size of the basis
  int converged_ = 0, operations_ = 0;
  VectorXd ritz_values_; // decreasing
  MatrixXd ritz_vectors_;
};

} // namespace

EigenPairs block_lanczos(const SparseMatrix& M, const SparseFactor& factor, double sigma,
                         const LanczosSettings& settings) {
  const int n = static_cast<int>(M.rows());
  const int count = std::min(settings.count, n - 1);
  // Wide enough for most runs to need no restart.
  const int wide = 2 * count + 8 * block, narrowest = count + 3 * block;
  const int capacity =
      std::min(n, settings.subspace > 0 ? std::max(settings.subspace, narrowest) : wide);
  const SparseMatrix pruned = M.pruned();
  const ShiftInvert shift_invert(pruned, factor);
  BlockLanczos search(shift_invert, count, capacity, settings.seed);
  search.run();
  EigenPairs pairs;
  pairs.operations = search.operations();
  pairs.converged = search.converged();
  if (!pairs.converged)
    pairs.reason = "Lanczos converged " + std::to_string(search.converged_pairs()) + " of " +
                   std::to_string(count) + " modes";
  pairs.values = sigma + search.theta().cwiseInverse().array();
  pairs.vectors = shift_invert.shapes(search.vectors());
  if (pairs.vectors.cols() > 0) purify(pairs, pruned, factor, sigma);
  return pairs;
}

} // namespace plica

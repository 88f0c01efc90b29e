#include "solve/block_lanczos.hpp"

#include "solve/dense_product.hpp"
#include "solve/shift_invert.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int block = 8;
constexpr double tolerance = 1e-8; // residual of a Ritz pair over its theta

// Vectors, and B times them.
struct Weighted {
  MatrixXd X, BX;
  Index cols() const { return X.cols(); }
};

// W = Q R with Q' B Q = I, of as many columns as W has rank: by the eigenvalues of W' B W, whose
// columns are scaled first (Stathopoulos & Wu, SIAM J. Sci. Comput. 23 (2002) 2165). The square
// loses half of the digits: once more makes Q orthonormal to all of them. `size` is what the
// columns were before they were made orthogonal to others: what is left of rounding is no
// direction.
struct Orthonormal {
  Weighted Q;
  MatrixXd R;
};

VectorXd lengths(const Weighted& W) {
  return W.X.cwiseProduct(W.BX).colwise().sum().cwiseMax(0).cwiseSqrt().transpose();
}

Orthonormal orthonormal(const Weighted& W, const VectorXd& size) {
  constexpr double nothing = 1e-14, dependent = 1e-14; // shares of a length, of a square
  VectorXd length = lengths(W);
  length = (length.array() > nothing * size.array()).select(length, 0);
  const VectorXd scale = length.unaryExpr([](double l) { return l > 0 ? 1 / l : 0.; });
  const MatrixXd gram = scale.asDiagonal() * transposed_product(W.X, W.BX) * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(symmetrised(gram));
  const auto rank = (eigen.eigenvalues().array() > dependent).count();
  const MatrixXd directions = eigen.eigenvectors().rightCols(rank);
  const VectorXd root = eigen.eigenvalues().tail(rank).cwiseSqrt();
  const MatrixXd turn = scale.asDiagonal() * directions * root.cwiseInverse().asDiagonal();
  return {{product(W.X, turn), product(W.BX, turn)},
          root.asDiagonal() * directions.transpose() * length.asDiagonal()};
}

class BlockLanczos {
public:
  BlockLanczos(const LanczosOperator& S, const RitzRequest& request, int capacity)
      : S_(S), lowest_(request.lowest), highest_(request.highest), seed_(request.seed),
        V_(S.rows(), capacity), T_(MatrixXd::Zero(capacity, capacity)) {}

  // Until the pairs at the ends have converged.
  void run() {
    constexpr int most_blocks = 5000;
    Weighted next = new_directions();
    for (int i = 0; i < most_blocks && next.cols() > 0 && !converged(); ++i) {
      append(next);
      next = step(next);
      if (next.cols() > 0 && size_ + next.cols() <= V_.cols() && size_ < next_look_) continue;
      look();
      if (next.cols() == 0) next = new_directions(); // the space is invariant
      if (!converged() && size_ + next.cols() > V_.cols()) restart();
    }
  }

  RitzPairs pairs() const {
    RitzPairs p;
    const Index low = found_lowest(), high = found_highest();
    p.lowest = ritz_values_.head(low);
    p.highest = ritz_values_.tail(high).reverse();
    MatrixXd ends(ritz_vectors_.rows(), low + high);
    ends << ritz_vectors_.leftCols(low), ritz_vectors_.rightCols(high).rowwise().reverse();
    p.vectors = product(V_.leftCols(ends.rows()), ends);
    p.converged_lowest = converged_lowest_;
    p.converged_highest = converged_highest_;
    p.converged = converged();
    p.operations = operations_;
    return p;
  }

private:
  bool converged() const {
    return looked_ && converged_lowest_ >= lowest_ && converged_highest_ >= highest_;
  }
  Index found_lowest() const {
    return std::min<Index>(lowest_, (ritz_values_.array() < 0).count());
  }
  Index found_highest() const {
    return std::min<Index>(highest_, ritz_values_.size() - found_lowest());
  }

  // Orthonormal, and orthogonal to the basis; none where the basis is all there is.
  Weighted new_directions() {
    const auto columns = std::min<Index>(block, S_.rows() - size_);
    if (columns == 0) return {};
    MatrixXd W = S_.random_in_range(static_cast<int>(columns), seed_++);
    return outside(W).Q;
  }

  void append(const Weighted& next) {
    V_.middleCols(size_, next.cols()) = next.X;
    last_ = next.cols();
    size_ += last_;
  }

  // V' B W, and W without it.
  MatrixXd project_out(Weighted& W) const {
    const MatrixXd H = transposed_product(V_.leftCols(size_), W.BX);
    subtract_product(W.X, V_.leftCols(size_), H);
    W.BX = S_.weighted(W.X);
    return H;
  }

  // Q and R of what of W lies outside of the basis, and V' B W. Twice: what the first time leaves
  // inside it grows as short directions are made unit ones.
  struct Outside {
    Weighted Q;
    MatrixXd R, H;
  };
  Outside outside(MatrixXd& X) const {
    Weighted W{std::move(X), {}};
    W.BX = S_.weighted(W.X);
    const VectorXd size = lengths(W);
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
  Weighted step(const Weighted& last) {
    MatrixXd W = S_.applied(last.X, last.BX);
    operations_ += static_cast<int>(last_);
    Outside next = outside(W);
    T_.block(0, size_ - last_, size_, last_) = next.H;
    T_.block(size_ - last_, 0, last_, size_) = next.H.transpose();
    remainder_ = std::move(next.R);
    return std::move(next.Q);
  }

  // Ritz pairs, theta increasing, and how many have converged from either end inwards.
  void look() {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(
        symmetrised(T_.topLeftCorner(size_, size_)));
    ritz_values_ = eigen.eigenvalues();
    ritz_vectors_ = eigen.eigenvectors();
    looked_ = true;
    converged_lowest_ = converged_highest_ = 0;
    while (converged_lowest_ < found_lowest() && is_converged(converged_lowest_))
      ++converged_lowest_;
    while (converged_highest_ < found_highest() && is_converged(size_ - 1 - converged_highest_))
      ++converged_highest_;
    next_look_ = size_ + std::max<Index>(block, size_ / 16);
  }

  bool is_converged(Index i) const {
    constexpr double rounding = 10 * std::numeric_limits<double>::epsilon();
    const double residual = (remainder_ * ritz_vectors_.col(i).tail(last_)).norm();
    return residual <= std::max(tolerance * std::abs(ritz_values_[i]),
                                rounding * ritz_values_.cwiseAbs().maxCoeff());
  }

  // The best Ritz vectors alone.
  void restart() {
    const Index more = lowest_ > 0 ? block / 2 : block;
    const Index most = V_.cols() - 2 * block;
    const Index low = lowest_ > 0 ? std::min<Index>(lowest_ + more, most) : 0;
    const Index high = std::min<Index>(highest_ + more, most - low);
    const Index kept = low + high;
    VectorXd values(kept);
    values << ritz_values_.head(low), ritz_values_.tail(high);
    MatrixXd vectors(size_, kept);
    vectors << ritz_vectors_.leftCols(low), ritz_vectors_.rightCols(high);
    V_.leftCols(kept) = product(V_.leftCols(size_), vectors);
    T_.setZero();
    T_.diagonal().head(kept) = values;
    ritz_values_ = values;
    ritz_vectors_ = MatrixXd::Identity(kept, kept);
    size_ = kept;
    next_look_ = lowest_ + highest_ + 2 * block;
  }

  const LanczosOperator& S_;
  int lowest_, highest_;
  unsigned seed_;
  MatrixXd V_, T_, remainder_; // R of the last block
  Index size_ = 0, last_ = 0;  // columns of V in use, those of the last block
  Index next_look_ = 0;        // at this size of the basis
  int converged_lowest_ = 0, converged_highest_ = 0, operations_ = 0;
  bool looked_ = false;
  VectorXd ritz_values_; // increasing
  MatrixXd ritz_vectors_;
};

// The operator of shift_invert.hpp.
class Plain : public LanczosOperator {
public:
  explicit Plain(const ShiftInvert& S) : S_(S) {}
  Index rows() const override { return S_.rows(); }
  MatrixXd weighted(const MatrixXd& X) const override { return X; }
  MatrixXd applied(const MatrixXd& X, const MatrixXd&) const override { return S_ * X; }
  MatrixXd random_in_range(int columns, unsigned seed) const override {
    return S_.random_in_range(columns, seed);
  }

private:
  const ShiftInvert& S_;
};

} // namespace

RitzPairs ritz_pairs(const LanczosOperator& S, const RitzRequest& request) {
  const int n = static_cast<int>(S.rows()), count = request.lowest + request.highest;
  // Wide enough for most runs to need no restart.
  const int wide = 2 * count + 8 * block, narrowest = count + 3 * block;
  const int capacity =
      std::min(n, request.subspace > 0 ? std::max(request.subspace, narrowest) : wide);
  BlockLanczos search(S, request, capacity);
  search.run();
  return search.pairs();
}

EigenPairs block_lanczos(const SparseMatrix& M, const SparseFactor& factor, double sigma,
                         const LanczosSettings& settings) {
  const int count = std::min(settings.count, static_cast<int>(M.rows()) - 1);
  const SparseMatrix pruned = M.pruned();
  const ShiftInvert shift_invert(pruned, factor);
  const RitzPairs found = ritz_pairs(
      Plain(shift_invert),
      {.lowest = 0, .highest = count, .subspace = settings.subspace, .seed = settings.seed});
  EigenPairs pairs;
  pairs.operations = found.operations;
  pairs.converged = found.converged;
  if (!pairs.converged)
    pairs.reason = "Lanczos converged " + std::to_string(found.converged_highest) + " of " +
                   std::to_string(count) + " modes";
  pairs.values = sigma + found.highest.cwiseInverse().array();
  pairs.vectors = shift_invert.shapes(found.vectors);
  if (pairs.vectors.cols() > 0) purify(pairs, pruned, factor, sigma);
  return pairs;
}

} // namespace plica

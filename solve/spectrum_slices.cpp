#include "solve/spectrum_slices.hpp"

#include "solve/block_lanczos.hpp"
#include "solve/dense_product.hpp"
#include "solve/inertia_count.hpp"
#include "solve/signed_cholesky.hpp"
#include "words/short_text.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <random>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// (K - sigma M)^-1 M in the inner product of M.
class Slice : public LanczosOperator {
public:
  Slice(const SparseMatrix& M, const SignedCholesky& factor) : M_(M), factor_(factor) {}
  Index rows() const override { return M_.rows(); }
  MatrixXd weighted(const MatrixXd& X) const override { return symmetric_product(M_, X); }
  MatrixXd applied(const MatrixXd&, const MatrixXd& MX) const override { return factor_.solve(MX); }
  MatrixXd random_in_range(int columns, unsigned seed) const override {
    std::mt19937 random(seed);
    MatrixXd x(rows(), columns);
    for (double& value : x.reshaped()) value = double(random()) / double(std::mt19937::max()) - 0.5;
    return factor_.solve(weighted(x));
  }

private:
  const SparseMatrix& M_;
  const SignedCholesky& factor_;
};

double hertz(double lambda) {
  return std::sqrt(std::max(0., lambda)) / (2 * std::numbers::pi);
}

// How many Lanczos can find: what has no mass has none.
int pairs_of(const SparseMatrix& M) {
  const auto with_mass = (VectorXd(M.diagonal()).array() > 0).count();
  return static_cast<int>(std::min<Index>(with_mass, M.rows() - 1));
}

struct Pairs {
  VectorXd lambda; // increasing
  MatrixXd Phi;
};

// As purify() of lanczos.hpp.
Pairs purified(const Slice& S, const MatrixXd& V, double sigma) {
  const MatrixXd MV = S.weighted(V), x = S.applied(V, MV);
  const MatrixXd stiffness = transposed_product(x, MV), gram = transposed_product(x, S.weighted(x));
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> ritz(symmetrised(stiffness),
                                                                symmetrised(gram));
  return {(sigma + ritz.eigenvalues().array()).matrix(), product(x, ritz.eigenvectors())};
}

class Slicing {
public:
  Slicing(const SparseMatrix& K, const SparseMatrix& M, const SparseFactor& factor,
          const SliceSettings& settings)
      : K_(K), M_(M), pruned_(M.pruned()), settings_(settings), order_(factor.order()),
        most_(pairs_of(M)), count_(std::min(settings.count, most_)) {}

  EigenPairs run(const SparseFactor& factor, double sigma) {
    const int first = std::min(count_, settings_.slice);
    EigenPairs lowest =
        block_lanczos(M_, factor, sigma, {.count = first, .subspace = 0, .seed = settings_.seed});
    operations_ = lowest.operations;
    if (!lowest.converged || first == count_) return lowest;
    lambda_.resize(count_ + 2 * settings_.slice);
    Phi_.resize(M_.rows(), lambda_.size());
    take_over({std::move(lowest.values), std::move(lowest.vectors)}, 0, 0);
    while (known_ < count_ && reason_.empty()) next_slice();
    EigenPairs pairs;
    pairs.converged = reason_.empty();
    pairs.reason = reason_;
    pairs.operations = operations_;
    pairs.values = lambda_.head(known_);
    Phi_.conservativeResize(Eigen::NoChange, known_);
    pairs.vectors = std::move(Phi_);
    return pairs;
  }

private:
  struct Shift {
    double sigma;
    std::unique_ptr<SignedCholesky> factor;
    int below; // modes of the list above its last that lie below sigma
  };

  // Where half of `wanted` modes lie below, about; empty, with the reason, where none can be had.
  std::optional<Shift> place(int wanted) {
    const int m = std::min(known_ - 1, settings_.slice);
    const double last = lambda_[known_ - 1], spacing = (last - lambda_[known_ - 1 - m]) / m;
    double reach = 0.5 * wanted * spacing;
    constexpr int attempts = 12;
    for (int attempt = 0; attempt < attempts; ++attempt) {
      const double sigma = last + reach;
      const SparseMatrix A = shifted(K_, M_, sigma);
      if (!nodes_) nodes_ = std::make_shared<const Supernodes>(supernodes(A, order_));
      auto factor = std::make_unique<SignedCholesky>(A, nodes_);
      if (!factor->keeps_digits(K_)) {
        reach *= 0.97; // an eigenvalue is too near
        continue;
      }
      const int below = factor->negative_pivots() - known_;
      if (below < 0) {
        reason_ = "below " + short_text(hertz(sigma)) + " Hz there are " +
                  std::to_string(factor->negative_pivots()) + " modes by inertia, but " +
                  std::to_string(known_) + " were found";
        return {};
      }
      if (2 * below <= 3 * wanted / 2 + 2) return Shift{sigma, std::move(factor), below};
      reach *= 0.5 * wanted / below;
    }
    reason_ = "no count by inertia above " + short_text(hertz(last)) + " Hz can be believed";
    return {};
  }

  void next_slice() {
    constexpr int guard = 4; // beyond those wanted, so that the last of them are accurate
    const int wanted = std::min(settings_.slice, count_ - known_ + guard);
    const std::optional<Shift> shift = place(wanted);
    if (!shift) return;
    const Slice S(pruned_, *shift->factor);
    const int above = std::max(wanted - shift->below, guard);
    for (int overlap = std::min(8, known_);; overlap = std::min(2 * overlap, known_)) {
      const RitzPairs found =
          ritz_pairs(S, {.lowest = shift->below + overlap,
                         .highest = std::min(above, most_ - known_ - shift->below),
                         .subspace = 0,
                         .seed = settings_.seed});
      operations_ += found.operations;
      if (!found.converged) {
        reason_ = "Lanczos at " + short_text(hertz(shift->sigma)) + " Hz converged " +
                  std::to_string(found.converged_lowest) + " of " +
                  std::to_string(shift->below + overlap) + " modes below it";
        return;
      }
      Pairs pairs = purified(S, found.vectors, shift->sigma);
      const int kept = widest_gap_in(pairs.lambda.head(overlap));
      if (meets(pairs.lambda.head(kept), overlap)) {
        take_over(std::move(pairs), known_ - overlap + kept, kept);
        return;
      }
      if (overlap == known_) break;
    }
    reason_ = "modes around " + short_text(hertz(lambda_[known_ - 1])) +
              " Hz differ from one slice to the next";
  }

  // That the first of a slice are where the list has them.
  bool meets(const VectorXd& lambda, int overlap) const {
    constexpr double near = 1e-6;
    const auto own = lambda_.segment(known_ - overlap, lambda.size());
    return (lambda - own).cwiseAbs().maxCoeff() < near * lambda_[known_ - 1];
  }

  // How many of an overlap stay those of the list: up to its widest gap, its ends left out.
  static int widest_gap_in(const VectorXd& lambda) {
    Index best = std::min<Index>(2, lambda.size() - 1);
    for (Index m = best + 1; m + 1 < lambda.size(); ++m)
      if (lambda[m] - lambda[m - 1] > lambda[best] - lambda[best - 1]) best = m;
    return static_cast<int>(best);
  }

  // The list up to `kept`, then the pairs from `first` on.
  void take_over(Pairs pairs, int kept, int first) {
    const Index more = pairs.lambda.size() - first;
    if (kept + more > lambda_.size()) {
      lambda_.conservativeResize(kept + more);
      Phi_.conservativeResize(Eigen::NoChange, kept + more);
    }
    lambda_.segment(kept, more) = pairs.lambda.tail(more);
    Phi_.middleCols(kept, more) = pairs.Phi.rightCols(more);
    known_ = kept + static_cast<int>(more);
  }

  const SparseMatrix &K_, &M_;
  SparseMatrix pruned_;
  SliceSettings settings_;
  const Eigen::VectorXi& order_;
  std::shared_ptr<const Supernodes> nodes_;
  int most_, count_;
  VectorXd lambda_; // of the list, and room
  MatrixXd Phi_;
  int known_ = 0; // in the list
  int operations_ = 0;
  std::string reason_;
};

} // namespace

EigenPairs spectrum_slices(const SparseMatrix& K, const SparseMatrix& M, const SparseFactor& factor,
                           double sigma, const SliceSettings& settings) {
  return Slicing(K, M, factor, settings).run(factor, sigma);
}

std::optional<int> count_roughly(const SparseMatrix& K, const SparseMatrix& M, double sigma,
                                 const SparseFactor& factor) {
  const SignedCholesky signs(shifted(K, M, sigma), factor.order());
  if (!signs.keeps_digits(K)) return {};
  return signs.negative_pivots();
}

} // namespace plica

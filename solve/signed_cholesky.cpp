#include "solve/signed_cholesky.hpp"

#include "solve/parallel.hpp"
#include "solve/supernodal_solve.hpp"

#include <algorithm>
#include <atomic>
#include <cblas.h>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Eigen::VectorXi;

// P A P' by columns, lower triangle.
SparseMatrix permuted(const SparseMatrix& lower, const VectorXi& order) {
  const auto n = static_cast<int>(lower.rows());
  VectorXi place(n);
  for (int i = 0; i < n; ++i) place[order[i]] = i;
  SparseMatrix result(n, n);
  result.selfadjointView<Eigen::Lower>() =
      lower.selfadjointView<Eigen::Lower>().twistedBy(place.asPermutation());
  return result;
}

// What all cores work at; each writes to supernodes of its own.
struct Shared {
  const Supernodes& nodes;
  const SparseMatrix& A;
  double* numbers;
  VectorXd &sign, &squares;       // squares: as many as rows of sums
  std::vector<int> waiting, next; // lists of those that contribute to a supernode
  std::vector<int> done;          // rows of a supernode that have contributed

  double* of(int s) const { return numbers + nodes.numbers_at[s]; }
};

// The supernodes of one subtree or those of the trunk, one after the other.
class Factorising {
public:
  Factorising(Shared& all, int last)
      : all_(all), nodes_(all.nodes), place_(std::size_t(nodes_.size()), -1), last_(last) {}

  bool factor(int s) {
    begin(s);
    for (int d = all_.waiting[s]; d >= 0;) {
      const int following = all_.next[d];
      take_off(d, s);
      pass_on(d);
      d = following;
    }
    if (!factor_columns(s)) return false;
    all_.done[s] = nodes_.columns(s);
    pass_on(s);
    return true;
  }

  // Supernode d waits for the supernode in which its next row is a column, or leaves.
  void pass_on(int d) {
    if (all_.done[d] >= nodes_.height(d)) return;
    const int s = nodes_.of_column[nodes_.row_numbers(d)[all_.done[d]]];
    if (s > last_) {
      leaving_.push_back(d);
      return;
    }
    all_.next[d] = all_.waiting[s];
    all_.waiting[s] = d;
  }

  const std::vector<int>& leaving() const { return leaving_; } // those that contribute to the trunk

private:
  // The columns of A.
  void begin(int s) {
    const int *row = nodes_.row_numbers(s), height = nodes_.height(s);
    for (int r = 0; r < height; ++r) place_[row[r]] = r;
    double* x = all_.of(s);
    std::fill_n(x, std::int64_t(nodes_.columns(s)) * height, 0.);
    for (int j = 0; j < nodes_.columns(s); ++j)
      for (SparseMatrix::InnerIterator it(all_.A, nodes_.first_column[s] + j); it; ++it)
        x[place_[it.row()] + std::int64_t(j) * height] = it.value();
  }

  // Takes what d contributes off the columns of s: L_d S L_d' in the rows of d from the first that
  // is a column of s on.
  void take_off(int d, int s) {
    const int first = all_.done[d], all = nodes_.height(d), width = nodes_.columns(d);
    const int* row = nodes_.row_numbers(d);
    int last = first;
    while (last < all && row[last] < nodes_.first_column[s + 1]) ++last;
    const int m = all - first, n = last - first;
    const double* L = all_.of(d) + first;
    product_.resize(std::max(product_.size(), std::size_t(m) * n));
    const Rows signs = with_signs(L, n, all, nodes_.first_column[d], width);
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, m, n, width, 1, L, all, signs.numbers,
                signs.stride, 0, product_.data(), m);
    double* x = all_.of(s);
    for (int j = 0; j < n; ++j) {
      double* column = x + std::int64_t(row[first + j] - nodes_.first_column[s]) * nodes_.height(s);
      const double* p = product_.data() + std::size_t(j) * m;
      for (int i = j; i < m; ++i) column[place_[row[first + i]]] -= p[i];
    }
    all_.done[d] = last;
  }

  struct Rows {
    const double* numbers;
    int stride;
  };

  // Rows of L times the signs of its columns: L itself where all are +1.
  Rows with_signs(const double* L, int n, int stride, int column, int width) {
    const auto signs = all_.sign.segment(column, width);
    if ((signs.array() > 0).all()) return {L, stride};
    signed_.resize(std::max(signed_.size(), std::size_t(n) * width));
    for (int k = 0; k < width; ++k)
      for (int i = 0; i < n; ++i)
        signed_[std::size_t(k) * n + i] = signs[k] * L[std::int64_t(k) * stride + i];
    return {signed_.data(), n};
  }

  // The dense columns of s, panel by panel.
  bool factor_columns(int s) {
    constexpr int panel = 48;
    const int n = nodes_.columns(s), m = nodes_.height(s), first = nodes_.first_column[s];
    double* x = all_.of(s);
    for (int j = 0; j < n; j += panel) {
      const int width = std::min(panel, n - j);
      double* top = x + j + std::int64_t(j) * m;
      if (!factor_top(top, m, width, first + j)) return false;
      const int below = m - j - width;
      if (below == 0) continue;
      cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, below, width, 1,
                  top, m, top + width, m);
      for (int k = 0; k < width; ++k)
        if (all_.sign[first + j + k] < 0)
          for (int i = 0; i < below; ++i) top[std::int64_t(k) * m + width + i] *= -1;
      for (int c = j + width; c < n; c += panel) { // the columns that are left, lower part
        const int block = std::min(panel, n - c);
        const double* L = x + c + std::int64_t(j) * m;
        const Rows signs = with_signs(L, block, m, first + j, width);
        cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, m - c, block, width, -1, L, m,
                    signs.numbers, signs.stride, 1, x + c + std::int64_t(c) * m, m);
      }
    }
    const int* sum = nodes_.sum_numbers(s);
    for (int j = 0; j < n; ++j)
      for (int i = j; i < m; ++i) {
        const double l = x[std::int64_t(j) * m + i];
        all_.squares[sum[i]] += l * l;
      }
    return true;
  }

  bool factor_top(double* x, int stride, int width, int column) {
    for (int j = 0; j < width; ++j) {
      double* own = x + std::int64_t(j) * stride;
      const double pivot = own[j];
      if (pivot == 0 || !std::isfinite(pivot)) return false;
      const double sign = pivot > 0 ? 1 : -1, root = std::sqrt(std::abs(pivot));
      all_.sign[column + j] = sign;
      own[j] = root;
      for (int i = j + 1; i < width; ++i) own[i] *= sign / root;
      for (int k = j + 1; k < width; ++k) {
        double* other = x + std::int64_t(k) * stride;
        const double factor = sign * own[k];
        for (int i = k; i < width; ++i) other[i] -= own[i] * factor;
      }
    }
    return true;
  }

  Shared& all_;
  const Supernodes& nodes_;
  std::vector<double> product_, signed_;
  std::vector<int> place_; // of a row among those of the supernode at work
  std::vector<int> leaving_;
  int last_; // supernode
};

// Subtrees side by side, then the trunk, to which they contribute in their order.
bool factorise(Shared& all) {
  const Supernodes& nodes = all.nodes;
  std::vector<std::vector<int>> leaving(nodes.subtrees.size());
  std::atomic<bool> ok = true;
  in_parallel(static_cast<int>(nodes.subtrees.size()), [&](int t) {
    const Supernodes::Subtree& tree = nodes.subtrees[t];
    Factorising work(all, tree.root);
    for (int s = tree.first; s <= tree.root && ok; ++s)
      if (!work.factor(s)) ok = false;
    leaving[t] = work.leaving();
  });
  if (!ok) return false;
  Factorising trunk(all, nodes.count());
  for (const std::vector<int>& from_subtree : leaving)
    for (int d : from_subtree) trunk.pass_on(d);
  return std::all_of(nodes.trunk.begin(), nodes.trunk.end(),
                     [&](int s) { return trunk.factor(s); });
}

} // namespace

SignedCholesky::SignedCholesky(const SparseMatrix& lower, const VectorXi& order)
    : SignedCholesky(lower, lower.rows() == 0
                                ? nullptr
                                : std::make_shared<const Supernodes>(supernodes(lower, order))) {}

SignedCholesky::SignedCholesky(const SparseMatrix& lower, std::shared_ptr<const Supernodes> nodes)
    : nodes_(std::move(nodes)), ok_(lower.rows() == 0) {
  if (ok_) return;
  const SparseMatrix A = permuted(lower, nodes_->order);
  numbers_ = std::make_unique_for_overwrite<double[]>(std::size_t(nodes_->numbers_at.back()));
  sign_ = VectorXd::Ones(A.rows());
  VectorXd sums = VectorXd::Zero(nodes_->sums);
  const auto count = std::size_t(nodes_->count());
  Shared all{.nodes = *nodes_,
             .A = A,
             .numbers = numbers_.get(),
             .sign = sign_,
             .squares = sums,
             .waiting = std::vector<int>(count, -1),
             .next = std::vector<int>(count, -1),
             .done = std::vector<int>(count, 0)};
  ok_ = factorise(all);
  negative_ = static_cast<int>((sign_.array() < 0).count());
  add_sums(*nodes_, 1, sums.data());
  squares_ = VectorXd(lower.rows());
  squares_(nodes_->order) = sums.head(lower.rows());
}

bool SignedCholesky::keeps_digits(const SparseMatrix& K) const {
  constexpr double most_growth = 1e6;
  if (!ok_ || squares_.size() == 0) return ok_;
  const VectorXd diagonal = VectorXd(K.diagonal()).cwiseAbs().cwiseMax(1e-300);
  return squares_.cwiseQuotient(diagonal).maxCoeff() < most_growth;
}

MatrixXd SignedCholesky::solve(const MatrixXd& b) const {
  if (b.size() == 0) return b;
  return solve_by_supernodes(*nodes_, numbers_.get(), sign_, b);
}

} // namespace plica

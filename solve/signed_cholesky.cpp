#include "solve/signed_cholesky.hpp"

#include "solve/cholmod_indices.hpp"

#include <algorithm>
#include <cblas.h>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Eigen::VectorXi;

// Columns that have one pattern below them, and where their rows and numbers lie.
struct Supernodes {
  std::vector<int> first_column;     // per supernode, and the end
  std::vector<std::int64_t> rows_at; // into rows, per supernode, and the end
  std::vector<std::int64_t> numbers_at;
  std::vector<int> rows; // of a supernode: its columns, then those below, increasing
  VectorXi order;        // row of the factor -> row of A

  int count() const { return static_cast<int>(first_column.size()) - 1; }
};

template <class T> std::vector<T> copied(const void* numbers, int index_type, std::size_t count) {
  return with_indices(numbers, index_type, [&](const auto* from) {
    std::vector<T> to(count);
    std::transform(from, from + count, to.begin(), [](auto x) { return static_cast<T>(x); });
    return to;
  });
}

Supernodes supernodes(const SparseMatrix& lower, const VectorXi& order) {
  const CholmodFunctions& cholmod = cholmod_functions(outgrows_narrow(lower.rows()));
  cholmod_common common{};
  cholmod.start(&common);
  common.print = 0;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_GIVEN;
  common.postorder = 1;
  common.supernodal = CHOLMOD_SUPERNODAL;
  CholmodView A(lower, cholmod.index_type);
  cholmod_factor* L = analyze_in_order(A, order, cholmod, common);
  Supernodes nodes;
  if (L != nullptr && L->is_super) {
    const std::size_t count = L->nsuper;
    nodes.first_column = copied<int>(L->super, cholmod.index_type, count + 1);
    nodes.rows_at = copied<std::int64_t>(L->pi, cholmod.index_type, count + 1);
    nodes.rows = copied<int>(L->s, cholmod.index_type, L->ssize);
    const auto rows = copied<int>(L->Perm, cholmod.index_type, L->n);
    nodes.order = Eigen::Map<const VectorXi>(rows.data(), Index(rows.size()));
  }
  const int status = common.status;
  cholmod.free_factor(&L, &common);
  cholmod.finish(&common);
  if (nodes.first_column.empty())
    throw std::runtime_error("sparse analysis failed: CHOLMOD status " + std::to_string(status));
  nodes.numbers_at = {0};
  for (int s = 0; s < nodes.count(); ++s) {
    const std::int64_t columns = nodes.first_column[s + 1] - nodes.first_column[s];
    nodes.numbers_at.push_back(nodes.numbers_at.back() +
                               columns * (nodes.rows_at[s + 1] - nodes.rows_at[s]));
  }
  return nodes;
}

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

class Factorising {
public:
  Factorising(const Supernodes& nodes, const SparseMatrix& A)
      : nodes_(nodes), A_(A), numbers_(std::size_t(nodes.numbers_at.back()), 0.),
        sign_(VectorXd::Ones(A.rows())), squares_(VectorXd::Zero(A.rows())),
        place_(std::size_t(A.rows()), -1), of_column_(std::size_t(A.rows())),
        waits_(std::size_t(nodes.count()), -1), next_(waits_.size(), -1), done_(waits_.size(), 0) {
    for (int s = 0; s < nodes.count(); ++s)
      std::fill(of_column_.begin() + nodes.first_column[s],
                of_column_.begin() + nodes.first_column[s + 1], s);
  }

  bool run() {
    for (int s = 0; s < nodes_.count(); ++s) {
      begin(s);
      for (int d = waits_[s]; d >= 0;) {
        const int following = next_[d];
        take_off(d, s);
        pass_on(d);
        d = following;
      }
      if (!factor(s)) return false;
      done_[s] = columns(s);
      pass_on(s);
    }
    return true;
  }

  int negative() const { return static_cast<int>((sign_.array() < 0).count()); }
  const VectorXd& squares() const { return squares_; }

private:
  int columns(int s) const { return nodes_.first_column[s + 1] - nodes_.first_column[s]; }
  int rows(int s) const { return static_cast<int>(nodes_.rows_at[s + 1] - nodes_.rows_at[s]); }
  const int* row_numbers(int s) const { return nodes_.rows.data() + nodes_.rows_at[s]; }
  double* numbers(int s) { return numbers_.data() + nodes_.numbers_at[s]; }

  // The columns of A.
  void begin(int s) {
    const int* row = row_numbers(s);
    for (int r = 0; r < rows(s); ++r) place_[row[r]] = r;
    double* x = numbers(s);
    for (int j = 0; j < columns(s); ++j)
      for (SparseMatrix::InnerIterator it(A_, nodes_.first_column[s] + j); it; ++it)
        x[place_[it.row()] + std::int64_t(j) * rows(s)] = it.value();
  }

  // Supernode d waits for the supernode in which its next row is a column.
  void pass_on(int d) {
    if (done_[d] >= rows(d)) return;
    const int s = of_column_[row_numbers(d)[done_[d]]];
    next_[d] = waits_[s];
    waits_[s] = d;
  }

  // Takes what d contributes off the columns of s: L_d S L_d' in the rows of d from the first that
  // is a column of s on.
  void take_off(int d, int s) {
    const int first = done_[d], all = rows(d), width = columns(d);
    const int* row = row_numbers(d);
    int last = first;
    while (last < all && row[last] < nodes_.first_column[s + 1]) ++last;
    const int m = all - first, n = last - first;
    const double* L = numbers(d) + first;
    product_.resize(std::max(product_.size(), std::size_t(m) * n));
    const Rows signs = with_signs(L, n, all, nodes_.first_column[d], width);
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, m, n, width, 1, L, all, signs.numbers,
                signs.stride, 0, product_.data(), m);
    double* x = numbers(s);
    for (int j = 0; j < n; ++j) {
      double* column = x + std::int64_t(row[first + j] - nodes_.first_column[s]) * rows(s);
      const double* p = product_.data() + std::size_t(j) * m;
      for (int i = j; i < m; ++i) column[place_[row[first + i]]] -= p[i];
    }
    done_[d] = last;
  }

  struct Rows {
    const double* numbers;
    int stride;
  };

  // Rows of L times the signs of its columns: L itself where all are +1.
  Rows with_signs(const double* L, int n, int stride, int column, int width) {
    const auto signs = sign_.segment(column, width);
    if ((signs.array() > 0).all()) return {L, stride};
    signed_.resize(std::max(signed_.size(), std::size_t(n) * width));
    for (int k = 0; k < width; ++k)
      for (int i = 0; i < n; ++i)
        signed_[std::size_t(k) * n + i] = signs[k] * L[std::int64_t(k) * stride + i];
    return {signed_.data(), n};
  }

  // The dense columns of s, panel by panel.
  bool factor(int s) {
    constexpr int panel = 48;
    const int n = columns(s), m = rows(s), first = nodes_.first_column[s];
    double* x = numbers(s);
    for (int j = 0; j < n; j += panel) {
      const int width = std::min(panel, n - j);
      double* top = x + j + std::int64_t(j) * m;
      if (!factor_top(top, m, width, first + j)) return false;
      const int below = m - j - width;
      if (below == 0) continue;
      cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, below, width, 1,
                  top, m, top + width, m);
      for (int k = 0; k < width; ++k)
        if (sign_[first + j + k] < 0)
          for (int i = 0; i < below; ++i) top[std::int64_t(k) * m + width + i] *= -1;
      for (int c = j + width; c < n; c += panel) { // the columns that are left, lower part
        const int block = std::min(panel, n - c);
        const double* L = x + c + std::int64_t(j) * m;
        const Rows signs = with_signs(L, block, m, first + j, width);
        cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, m - c, block, width, -1, L, m,
                    signs.numbers, signs.stride, 1, x + c + std::int64_t(c) * m, m);
      }
    }
    const int* row = row_numbers(s);
    for (int j = 0; j < n; ++j)
      for (int i = j; i < m; ++i) {
        const double l = x[std::int64_t(j) * m + i];
        squares_[row[i]] += l * l;
      }
    return true;
  }

  bool factor_top(double* x, int stride, int width, int column) {
    for (int j = 0; j < width; ++j) {
      double* own = x + std::int64_t(j) * stride;
      const double pivot = own[j];
      if (pivot == 0 || !std::isfinite(pivot)) return false;
      const double sign = pivot > 0 ? 1 : -1, root = std::sqrt(std::abs(pivot));
      sign_[column + j] = sign;
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

  const Supernodes& nodes_;
  const SparseMatrix& A_;
  std::vector<double> numbers_, product_, signed_;
  VectorXd sign_, squares_;
  std::vector<int> place_;        // of a row among those of the supernode at work
  std::vector<int> of_column_;    // supernode
  std::vector<int> waits_, next_; // lists of those that contribute to a supernode
  std::vector<int> done_;         // rows of a supernode that have contributed
};

} // namespace

SignedCholesky::SignedCholesky(const SparseMatrix& lower, const VectorXi& order) {
  if (lower.rows() == 0) {
    ok_ = true;
    return;
  }
  const Supernodes nodes = supernodes(lower, order);
  const SparseMatrix A = permuted(lower, nodes.order);
  Factorising work(nodes, A);
  ok_ = work.run();
  negative_ = work.negative();
  squares_ = VectorXd(lower.rows());
  squares_(nodes.order) = work.squares();
}

} // namespace plica

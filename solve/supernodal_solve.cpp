#include "solve/supernodal_solve.hpp"

#include "solve/parallel.hpp"

#include <algorithm>
#include <cblas.h>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// x is by rows of `width` numbers in the order of the factor, so that rows below a supernode are
// gathered and summed in long runs; after them the rows in which subtrees sum.
struct Sweep {
  const Supernodes& nodes;
  const double* numbers;
  int width;
  double* x;

  double* row(int r) const { return x + std::size_t(r) * width; }

  // L^-1: solves at s and takes it off the rows below.
  void down(int s, std::vector<double>& space) const {
    const int n = nodes.columns(s), m = nodes.height(s), below = m - n;
    const double* L = numbers + nodes.numbers_at[s];
    double* own = row(nodes.first_column[s]);
    cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, width, n, 1, L, m,
                own, width);
    if (below == 0) return;
    space.resize(std::max(space.size(), std::size_t(below) * width));
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, width, below, n, 1, own, width, L + n, m,
                0, space.data(), width);
    const int* to = nodes.sum_numbers(s) + n;
    for (int i = 0; i < below; ++i) {
      double* target = row(to[i]);
      const double* from = space.data() + std::size_t(i) * width;
      for (int c = 0; c < width; ++c) target[c] -= from[c];
    }
  }

  // L'^-1: takes the rows below off s and solves.
  void up(int s, std::vector<double>& space) const {
    const int n = nodes.columns(s), m = nodes.height(s), below = m - n;
    const double* L = numbers + nodes.numbers_at[s];
    double* own = row(nodes.first_column[s]);
    if (below > 0) {
      space.resize(std::max(space.size(), std::size_t(below) * width));
      const int* from = nodes.row_numbers(s) + n;
      for (int i = 0; i < below; ++i)
        std::copy_n(row(from[i]), width, space.data() + std::size_t(i) * width);
      cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, width, n, below, -1, space.data(),
                  width, L + n, m, 1, own, width);
    }
    cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasNoTrans, CblasNonUnit, width, n, 1, L,
                m, own, width);
  }

  // f(t, space) for all subtrees.
  template <class F> void in_subtrees(F&& f) const {
    if (nodes.subtrees.empty()) return;
    in_parallel(static_cast<int>(nodes.subtrees.size()), [&](int t) {
      std::vector<double> space;
      f(nodes.subtrees[t], space);
    });
  }

  void down_all() const {
    in_subtrees([&](const Supernodes::Subtree& tree, std::vector<double>& own) {
      for (int s = tree.first; s <= tree.root; ++s) down(s, own);
    });
    add_sums(nodes, width, x);
    std::vector<double> space;
    for (int s : nodes.trunk) down(s, space);
  }

  void up_all() const {
    std::vector<double> space;
    for (auto s = nodes.trunk.rbegin(); s != nodes.trunk.rend(); ++s) up(*s, space);
    in_subtrees([&](const Supernodes::Subtree& tree, std::vector<double>& own) {
      for (int s = tree.root; s >= tree.first; --s) up(s, own);
    });
  }
};

} // namespace

void add_sums(const Supernodes& nodes, int width, double* rows) {
  for (const Supernodes::Subtree& tree : nodes.subtrees) {
    const int* row = nodes.row_numbers(tree.root) + nodes.columns(tree.root);
    const int below = nodes.height(tree.root) - nodes.columns(tree.root);
    for (int i = 0; i < below; ++i)
      for (int c = 0; c < width; ++c)
        rows[std::size_t(row[i]) * width + c] += rows[std::size_t(tree.sums + i) * width + c];
  }
}

MatrixXd solve_by_supernodes(const Supernodes& nodes, const double* numbers, const VectorXd& sign,
                             const MatrixXd& b) {
  constexpr Index widest = 32;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  MatrixXd x(b.rows(), b.cols());
  for (Index first = 0; first < b.cols(); first += widest) {
    const Index width = std::min(widest, b.cols() - first);
    Rows rows(nodes.sums, width);
    rows.topRows(b.rows()) = b(nodes.order, Eigen::seqN(first, width));
    rows.bottomRows(nodes.sums - b.rows()).setZero();
    const Sweep sweep{nodes, numbers, int(width), rows.data()};
    sweep.down_all();
    rows.topRows(b.rows()).array().colwise() *= sign.array();
    sweep.up_all();
    x(nodes.order, Eigen::seqN(first, width)) = rows.topRows(b.rows());
  }
  return x;
}

} // namespace plica

#include "solve/dense_product.hpp"

#include "solve/parallel.hpp"

#include <algorithm>
#include <cblas.h>

namespace plica {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

// C = alpha op(A) B + beta C.
void multiply(double alpha, CBLAS_TRANSPOSE op, const Eigen::Ref<const MatrixXd>& A,
              const Eigen::Ref<const MatrixXd>& B, double beta, Eigen::Ref<MatrixXd> C) {
  if (C.size() == 0 || B.rows() == 0) return;
  cblas_dgemm(CblasColMajor, op, CblasNoTrans, int(C.rows()), int(C.cols()), int(B.rows()), alpha,
              A.data(), int(A.outerStride()), B.data(), int(B.outerStride()), beta, C.data(),
              int(C.outerStride()));
}

// f(first, count) for pieces of [0, size) that the cores share where the work is worth it; the same
// pieces for any number of threads.
template <class F> void in_pieces(Index size, double operations, F&& f) {
  constexpr double worth_sharing = 2e7;
  constexpr Index many = 4;
  if (operations < worth_sharing) return f(Index(0), size);
  const Index pieces = std::min(many, size);
  in_parallel(int(pieces), [&](int i) {
    const Index first = size * i / pieces;
    f(first, size * (i + 1) / pieces - first);
  });
}

double operations(const Eigen::Ref<const MatrixXd>& A, const Eigen::Ref<const MatrixXd>& B) {
  return double(A.size()) * double(B.cols());
}

} // namespace

MatrixXd transposed_product(const Eigen::Ref<const MatrixXd>& A,
                            const Eigen::Ref<const MatrixXd>& B) {
  MatrixXd C = MatrixXd::Zero(A.cols(), B.cols());
  in_pieces(A.cols(), operations(A, B), [&](Index first, Index count) {
    multiply(1, CblasTrans, A.middleCols(first, count), B, 0, C.middleRows(first, count));
  });
  return C;
}

MatrixXd product(const Eigen::Ref<const MatrixXd>& A, const Eigen::Ref<const MatrixXd>& B) {
  MatrixXd C = MatrixXd::Zero(A.rows(), B.cols());
  in_pieces(A.rows(), operations(A, B), [&](Index first, Index count) {
    multiply(1, CblasNoTrans, A.middleRows(first, count), B, 0, C.middleRows(first, count));
  });
  return C;
}

void subtract_product(MatrixXd& C, const Eigen::Ref<const MatrixXd>& A,
                      const Eigen::Ref<const MatrixXd>& B) {
  in_pieces(A.rows(), operations(A, B), [&](Index first, Index count) {
    multiply(-1, CblasNoTrans, A.middleRows(first, count), B, 1, C.middleRows(first, count));
  });
}

} // namespace plica

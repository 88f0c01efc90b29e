#include "solve/dense_product.hpp"

#include <cblas.h>

namespace plica {

using Eigen::MatrixXd;

namespace {

// C = alpha op(A) B + beta C.
void multiply(double alpha, CBLAS_TRANSPOSE op, const Eigen::Ref<const MatrixXd>& A,
              const Eigen::Ref<const MatrixXd>& B, double beta, MatrixXd& C) {
  if (C.size() == 0 || B.rows() == 0) return;
  cblas_dgemm(CblasColMajor, op, CblasNoTrans, int(C.rows()), int(C.cols()), int(B.rows()), alpha,
              A.data(), int(A.outerStride()), B.data(), int(B.outerStride()), beta, C.data(),
              int(C.outerStride()));
}

} // namespace

MatrixXd transposed_product(const Eigen::Ref<const MatrixXd>& A,
                            const Eigen::Ref<const MatrixXd>& B) {
  MatrixXd C = MatrixXd::Zero(A.cols(), B.cols());
  multiply(1, CblasTrans, A, B, 0, C);
  return C;
}

MatrixXd product(const Eigen::Ref<const MatrixXd>& A, const Eigen::Ref<const MatrixXd>& B) {
  MatrixXd C = MatrixXd::Zero(A.rows(), B.cols());
  multiply(1, CblasNoTrans, A, B, 0, C);
  return C;
}

void subtract_product(MatrixXd& C, const Eigen::Ref<const MatrixXd>& A,
                      const Eigen::Ref<const MatrixXd>& B) {
  multiply(-1, CblasNoTrans, A, B, 1, C);
}

} // namespace plica

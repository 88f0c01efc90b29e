#include "solve/dense_product.hpp"

#include <cblas.h>

namespace plica {

using Eigen::MatrixXd;

MatrixXd transposed_product(const Eigen::Ref<const MatrixXd>& A,
                            const Eigen::Ref<const MatrixXd>& B) {
  MatrixXd C = MatrixXd::Zero(A.cols(), B.cols());
  if (C.size() == 0 || A.rows() == 0) return C;
  cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, int(C.rows()), int(C.cols()), int(A.rows()),
              1, A.data(), int(A.outerStride()), B.data(), int(B.outerStride()), 0, C.data(),
              int(C.outerStride()));
  return C;
}

void subtract_product(MatrixXd& C, const MatrixXd& A, const MatrixXd& B) {
  if (C.size() == 0 || A.cols() == 0) return;
  cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, int(C.rows()), int(C.cols()),
              int(A.cols()), -1, A.data(), int(A.outerStride()), B.data(), int(B.outerStride()), 1,
              C.data(), int(C.outerStride()));
}

} // namespace plica

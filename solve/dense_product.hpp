// Products of tall dense matrices by BLAS, which has kernels for the processor that it runs on.
#pragma once

#include <Eigen/Core>

namespace plica {

// A' B.
Eigen::MatrixXd transposed_product(const Eigen::Ref<const Eigen::MatrixXd>& A,
                                   const Eigen::Ref<const Eigen::MatrixXd>& B);

// A B.
Eigen::MatrixXd product(const Eigen::Ref<const Eigen::MatrixXd>& A,
                        const Eigen::Ref<const Eigen::MatrixXd>& B);

// C -= A B.
void subtract_product(Eigen::MatrixXd& C, const Eigen::Ref<const Eigen::MatrixXd>& A,
                      const Eigen::Ref<const Eigen::MatrixXd>& B);

// Of what is symmetric but for rounding.
inline Eigen::MatrixXd symmetrised(const Eigen::MatrixXd& A) {
  return (A + A.transpose()) / 2;
}

} // namespace plica

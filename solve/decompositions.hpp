// Eigen's dense decompositions of MatrixXd, compiled once (decompositions.cpp) instead of in every
// source that uses one. Read before every source from `solve/` on (cmake/PlicaLibrary.cmake); holds
// for arguments that are MatrixXd, not expressions.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

// What is instantiated, after `extern template` here and after `template` in decompositions.cpp.
// They name types. NOLINTBEGIN(bugprone-macro-parentheses)
// clang-format off
#define PLICA_DECOMPOSITIONS(KEYWORD)                                                              \
  KEYWORD class LLT<MatrixXd>;                                                                     \
  KEYWORD LLT<MatrixXd>& LLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);                       \
  KEYWORD class LDLT<MatrixXd>;                                                                    \
  KEYWORD LDLT<MatrixXd>& LDLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);                     \
  KEYWORD class SelfAdjointEigenSolver<MatrixXd>;                                                  \
  KEYWORD SelfAdjointEigenSolver<MatrixXd>&                                                        \
  SelfAdjointEigenSolver<MatrixXd>::compute(const EigenBase<MatrixXd>&, int);                      \
  KEYWORD class GeneralizedSelfAdjointEigenSolver<MatrixXd>;                                       \
  KEYWORD class HouseholderQR<MatrixXd>;                                                           \
  KEYWORD class ColPivHouseholderQR<MatrixXd>;                                                     \
  KEYWORD class PartialPivLU<MatrixXd>;
// Products of matrices by columns, of rows and columns, of columns and rows.
#define PLICA_PRODUCTS(KEYWORD)                                                                    \
  KEYWORD struct general_matrix_matrix_product<Index, double, ColMajor, false, double, ColMajor,   \
                                               false, ColMajor, 1>;                                \
  KEYWORD struct general_matrix_matrix_product<Index, double, RowMajor, false, double, ColMajor,   \
                                               false, ColMajor, 1>;                                \
  KEYWORD struct general_matrix_matrix_product<Index, double, ColMajor, false, double, RowMajor,   \
                                               false, ColMajor, 1>;
// clang-format on
// NOLINTEND(bugprone-macro-parentheses)

namespace Eigen {
PLICA_DECOMPOSITIONS(extern template)
namespace internal {
PLICA_PRODUCTS(extern template)
}
} // namespace Eigen

namespace plica {

// An orthonormal basis of the space of the columns, which are independent.
Eigen::MatrixXd orthonormal_columns(const Eigen::MatrixXd& A);

} // namespace plica

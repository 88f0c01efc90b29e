// Eigen's dense decompositions of MatrixXd, and what they and products of full matrices come down
// to, compiled once (decompositions.cpp) instead of in every source that uses one. Read before
// every source from `solve/` on (cmake/PlicaLibrary.cmake); holds for arguments that are MatrixXd,
// not expressions.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <complex>

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
  KEYWORD class PartialPivLU<MatrixXd>;                                                            \
  KEYWORD class PartialPivLU<MatrixXcd>;
// Products of full matrices and with vectors, by columns and by rows; triangles of a matrix and their
// inverse times another; the eigenvalues of a tridiagonal one.
#define PLICA_PRODUCTS(KEYWORD)                                                                    \
  KEYWORD struct general_matrix_matrix_product<Index, double, ColMajor, false, double, ColMajor,   \
                                               false, ColMajor, 1>;                                \
  KEYWORD struct general_matrix_matrix_product<Index, double, RowMajor, false, double, ColMajor,   \
                                               false, ColMajor, 1>;                                \
  KEYWORD struct general_matrix_matrix_product<Index, double, ColMajor, false, double, RowMajor,   \
                                               false, ColMajor, 1>;                                \
  KEYWORD struct general_matrix_matrix_product<Index, Complex, ColMajor, false, Complex, ColMajor, \
                                               false, ColMajor, 1>;                                \
  KEYWORD struct gebp_kernel<double, double, Index, blas_data_mapper<double, Index, ColMajor>,     \
                             gebp_traits<double, double>::mr, gebp_traits<double, double>::nr,     \
                             false, false>;                                                        \
  KEYWORD struct general_matrix_vector_product<                                                    \
      Index, double, const_blas_data_mapper<double, Index, ColMajor>, ColMajor, false, double,     \
      const_blas_data_mapper<double, Index, RowMajor>, false, 0>;                                  \
  KEYWORD struct general_matrix_vector_product<                                                    \
      Index, double, const_blas_data_mapper<double, Index, RowMajor>, RowMajor, false, double,     \
      const_blas_data_mapper<double, Index, ColMajor>, false, 0>;                                  \
  KEYWORD struct general_matrix_vector_product<                                                    \
      Index, Complex, const_blas_data_mapper<Complex, Index, ColMajor>, ColMajor, false, Complex,  \
      const_blas_data_mapper<Complex, Index, RowMajor>, false, 0>;                                 \
  KEYWORD struct general_matrix_vector_product<                                                    \
      Index, Complex, const_blas_data_mapper<Complex, Index, RowMajor>, RowMajor, false, Complex,  \
      const_blas_data_mapper<Complex, Index, ColMajor>, false, 0>;                                 \
  KEYWORD struct triangular_solve_matrix<double, Index, OnTheLeft, Lower, false, ColMajor,         \
                                         ColMajor, 1>;                                             \
  KEYWORD struct triangular_solve_matrix<double, Index, OnTheLeft, Upper, false, ColMajor,         \
                                         ColMajor, 1>;                                             \
  KEYWORD struct triangular_solve_matrix<double, Index, OnTheLeft, UnitLower, false, ColMajor,     \
                                         ColMajor, 1>;                                             \
  KEYWORD struct triangular_solve_matrix<double, Index, OnTheLeft, Upper, false, RowMajor,         \
                                         ColMajor, 1>;                                             \
  KEYWORD struct triangular_solve_matrix<double, Index, OnTheLeft, UnitUpper, false, RowMajor,     \
                                         ColMajor, 1>;                                             \
  KEYWORD struct triangular_solve_matrix<Complex, Index, OnTheLeft, Upper, false, ColMajor,        \
                                         ColMajor, 1>;                                             \
  KEYWORD struct triangular_solve_matrix<Complex, Index, OnTheLeft, UnitLower, false, ColMajor,    \
                                         ColMajor, 1>;                                             \
  KEYWORD struct product_triangular_matrix_matrix<double, Index, Lower, true, ColMajor, false,     \
                                                  ColMajor, false, ColMajor, 1>;                   \
  KEYWORD struct product_triangular_matrix_matrix<double, Index, UnitLower, true, ColMajor, false, \
                                                  ColMajor, false, ColMajor, 1>;                   \
  KEYWORD struct product_triangular_matrix_matrix<double, Index, Upper, true, RowMajor, false,     \
                                                  ColMajor, false, ColMajor, 1>;                   \
  KEYWORD struct product_triangular_matrix_matrix<double, Index, UnitUpper, true, RowMajor, false, \
                                                  ColMajor, false, ColMajor, 1>;                   \
  KEYWORD void tridiagonalization_inplace(MatrixXd&, VectorXd&);                                   \
  KEYWORD ComputationInfo computeFromTridiagonal_impl(VectorXd&, VectorXd&, const Index, bool,     \
                                                      MatrixXd&);
// clang-format on
// NOLINTEND(bugprone-macro-parentheses)

namespace Eigen {
PLICA_DECOMPOSITIONS(extern template)
namespace internal {
using Complex = std::complex<double>;
PLICA_PRODUCTS(extern template)
} // namespace internal
} // namespace Eigen

namespace plica {

// An orthonormal basis of the space of the columns, which are independent.
Eigen::MatrixXd orthonormal_columns(const Eigen::MatrixXd& A);

} // namespace plica

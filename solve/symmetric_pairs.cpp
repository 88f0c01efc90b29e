#include "solve/symmetric_pairs.hpp"

#include <Eigen/Eigenvalues>
#include <vector>

// Of OpenBLAS, which holds LAPACK besides.
extern "C" void dsygvd_(const int* kind, const char* vectors, const char* triangle, const int* n,
                        double* A, const int* rows_of_A, double* B, const int* rows_of_B,
                        double* values, double* work, const int* length, int* int_work,
                        const int* int_length, int* info);

namespace plica {

using Eigen::MatrixXd;

namespace {

std::optional<SymmetricPairs> by_eigen(const MatrixXd& A, const MatrixXd& B) {
  if (Eigen::LLT<MatrixXd>(B).info() != Eigen::Success) return std::nullopt;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> pairs(A, B);
  if (pairs.info() != Eigen::Success) return std::nullopt;
  return SymmetricPairs{pairs.eigenvalues(), pairs.eigenvectors()};
}

} // namespace

std::optional<SymmetricPairs> symmetric_pairs(MatrixXd A, MatrixXd B) {
  constexpr Eigen::Index few = 64;
  if (A.rows() < few) return by_eigen(A, B);
  const int n = int(A.rows()), kind = 1, length = 1 + 6 * n + 2 * n * n, int_length = 3 + 5 * n;
  Eigen::VectorXd values(n), work(length);
  std::vector<int> int_work(std::size_t(int_length), 0);
  int info = 0;
  dsygvd_(&kind, "V", "L", &n, A.data(), &n, B.data(), &n, values.data(), work.data(), &length,
          int_work.data(), &int_length, &info);
  if (info != 0) return std::nullopt;
  return SymmetricPairs{std::move(values), std::move(A)};
}

} // namespace plica

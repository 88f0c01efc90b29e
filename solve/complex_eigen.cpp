#include "solve/complex_eigen.hpp"

#include <algorithm>
#include <complex>
#include <stdexcept>
#include <vector>

// Of OpenBLAS, which holds LAPACK besides.
extern "C" void zgeev_(const char* left, const char* right, const int* n, std::complex<double>* A,
                       const int* rows_of_A, std::complex<double>* values,
                       std::complex<double>* left_vectors, const int* rows_of_left,
                       std::complex<double>* right_vectors, const int* rows_of_right,
                       std::complex<double>* work, const int* length, double* real_work, int* info);

namespace plica {

ComplexEigen complex_eigen(Eigen::MatrixXcd A) {
  const int n = int(A.rows()), one = 1, length = std::max(64 * n, 1);
  ComplexEigen eigen{Eigen::VectorXcd(n), Eigen::MatrixXcd(n, n)};
  if (n == 0) return eigen;
  std::vector<std::complex<double>> work(static_cast<std::size_t>(length));
  std::vector<double> real_work(2 * static_cast<std::size_t>(n));
  std::complex<double> none;
  int info = 0;
  zgeev_("N", "V", &n, A.data(), &n, eigen.values.data(), &none, &one, eigen.vectors.data(), &n,
         work.data(), &length, real_work.data(), &info);
  if (info != 0) throw std::runtime_error("eigenvalues of a complex matrix: no convergence");
  return eigen;
}

} // namespace plica

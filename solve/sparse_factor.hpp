// CHOLMOD (Chen, Davis, Hager & Rajamanickam, ACM TOMS 35 (2008) 22), wrapped once.
//
// A = L L' (supernodal, for solves) or P' L D L' P (simplicial, for counting negative pivots; it
// does not pivot for size, so a count is to be trusted only away from the spectrum). The pattern is
// analysed once; matrices of the same pattern are factored again without a new analysis.
#pragma once

#include "solve/assembly.hpp"

#include <memory>
#include <string>

namespace plica {

enum class Factorisation { cholesky, ldlt };

// Of the numbers of rows and entries in a factor: by_size takes 64 bits from four million rows on,
// where the entries of a factor begin to outgrow 32. The numbers of a factor are the same.
enum class IndexWidth { by_size, wide };

struct FactorStatus {
  bool ok = false;
  int failed_column = -1; // Cholesky: the column whose pivot is not positive
  std::string reason;     // why not ok, in words
};

class SparseFactor {
public:
  // Analyses the pattern of a symmetric matrix (lower triangle); the same pattern gives the same
  // order whatever runs beside it. Throws std::runtime_error when memory is short.
  explicit SparseFactor(const SparseMatrix& pattern, Factorisation kind = Factorisation::cholesky,
                        IndexWidth width = IndexWidth::by_size);
  ~SparseFactor();
  SparseFactor(SparseFactor&&) noexcept;
  SparseFactor& operator=(SparseFactor&&) noexcept;

  // Factors a matrix with the pattern analysed. Not positive definite is a status, not an error.
  FactorStatus factorise(const SparseMatrix& lower);

  // A^-1 b. Many columns go in groups that the cores share; a group is the same, and so is the
  // result, for any number of threads. Needs a successful factorise().
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;
  // b' A^-1 b, symmetric, from one forward solve. Cholesky only.
  Eigen::MatrixXd quadratic_form(const SparseMatrix& b) const;
  // L^-1 b and L'^-1 b of A = P' L L' P, for one vector of rows() numbers in the order of the
  // factor, without allocation after the first call. Cholesky only.
  void solve_lower(const double* b, double* x) const;
  void solve_upper(const double* b, double* x) const;
  // The same for all columns, in groups as above: sixteen cost five times one.
  Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& b) const;
  Eigen::MatrixXd solve_upper(const Eigen::MatrixXd& b) const;
  // P: row of the factor -> row of A.
  const Eigen::VectorXi& order() const;

  int rows() const;
  int negative_pivots() const; // ldlt only
  double factor_entries() const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// Threads of OpenMP regions, 0 = all cores; BLAS gets one. The supernodes of a shell are small: a
// second BLAS thread gains little in the factorisation, nothing in solves, and costs a multiple
// when the other core is busy (bench/bench_kernels.cpp measures it).
void set_threads(int threads);
void set_blas_threads(int threads);

// Peak resident memory of this process in bytes.
double peak_memory();

} // namespace plica

#include "solve/shift_invert.hpp"

#include <omp.h>
#include <random>

namespace plica {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Eigen::VectorXi;

namespace {

constexpr Index worth_a_team = 500000; // entries of the mass

SparseMatrix in_order(const SparseMatrix& lower, const SparseFactor& factor) {
  const Eigen::PermutationMatrix<Eigen::Dynamic> to_rows{VectorXi(factor.order())};
  SparseMatrix full;
  full = lower.selfadjointView<Eigen::Lower>().twistedBy(to_rows.transpose());
  return full;
}

} // namespace

ShiftInvert::ShiftInvert(const SparseMatrix& M, const SparseFactor& factor)
    : factor_(factor), mass_(in_order(M, factor)), x_(M.rows()), Mx_(M.rows()) {}

void ShiftInvert::perform_op(const double* x, double* y) const {
  factor_.solve_upper(x, x_.data());
  const int rows = int(mass_.outerSize());
#pragma omp parallel for schedule(static) if (mass_.nonZeros() > worth_a_team)
  for (int i = 0; i < rows; ++i) {
    double sum = 0;
    for (SparseMatrix::InnerIterator it(mass_, i); it; ++it) sum += it.value() * x_[it.row()];
    Mx_[i] = sum;
  }
  factor_.solve_lower(Mx_.data(), y);
}

// A column of the full matrix is also a row, summed in one order on any number of threads.
MatrixXd ShiftInvert::times_mass(const Rows& x) const {
  Rows y(x.rows(), x.cols());
  const int rows = int(mass_.outerSize());
#pragma omp parallel for schedule(static) if (mass_.nonZeros() > worth_a_team && !omp_in_parallel())
  for (int i = 0; i < rows; ++i) {
    auto sum = y.row(i);
    sum.setZero();
    for (SparseMatrix::InnerIterator it(mass_, i); it; ++it)
      sum.noalias() += it.value() * x.row(it.row());
  }
  return y;
}

MatrixXd ShiftInvert::operator*(const MatrixXd& X) const {
  return factor_.solve_lower(times_mass(factor_.solve_upper(X)));
}

MatrixXd ShiftInvert::random_in_range(int columns, unsigned seed) const {
  std::mt19937 random(seed);
  MatrixXd x(rows(), columns);
  for (double& value : x.reshaped()) value = double(random()) / double(std::mt19937::max()) - 0.5;
  return factor_.solve_lower(times_mass(x));
}

MatrixXd ShiftInvert::shapes(const MatrixXd& y) const {
  MatrixXd phi(y.rows(), y.cols());
  phi(factor_.order(), Eigen::all) = factor_.solve_upper(y);
  return phi;
}

} // namespace plica

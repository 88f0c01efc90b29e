// The operator of Lanczos in shift-invert mode,
//
//   K - sigma M = P' L L' P,   y = L^-1 P M P' L'^-1 x,   phi = P' L'^-1 y,
//
// symmetric in the plain inner product, also where M is semidefinite (see lanczos.hpp).
#pragma once

#include "solve/sparse_factor.hpp"

namespace plica {

class ShiftInvert {
public:
  using Scalar = double; // as Spectra wants it

  // `factor` is that of K - sigma M and must outlive this; M: lower triangle.
  ShiftInvert(const SparseMatrix& M, const SparseFactor& factor);

  Eigen::Index rows() const { return mass_.rows(); }
  Eigen::Index cols() const { return mass_.cols(); }

  void perform_op(const double* x, double* y) const; // one vector
  Eigen::MatrixXd operator*(const Eigen::MatrixXd& X) const;

  // L^-1 P M P' of columns drawn from a seed: in the range of the operator.
  Eigen::MatrixXd random_in_range(int columns, unsigned seed) const;

  Eigen::MatrixXd shapes(const Eigen::MatrixXd& y) const; // phi

private:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::MatrixXd times_mass(const Rows& x) const;

  const SparseFactor& factor_;
  SparseMatrix mass_; // in the order of the factor, both triangles
  mutable Eigen::VectorXd x_, Mx_;
};

} // namespace plica

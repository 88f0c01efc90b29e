// A sparse matrix by rows of ranks, as PETSc holds it, and products with blocks of columns.
#pragma once

#include "engine/petsc.hpp"

namespace plica {

// Rows of one rank, columns over all.
struct CompressedRows {
  std::vector<int> start, column; // column: increasing within a row
  std::vector<double> value;
};

class DistributedMatrix {
public:
  DistributedMatrix() = default;
  // Collective; `size`: rows of all ranks, as many columns. The matrix is symmetric.
  DistributedMatrix(const CompressedRows& own, int size, const Ranks& ranks);

  // Rows and columns of some unknowns; `own`: those of them that are this rank's, increasing.
  DistributedMatrix part(const std::vector<int>& own, const Ranks& ranks) const;

  Mat mat() const { return mat_; }
  int first() const { return first_; } // of the own rows
  Eigen::Index own_rows() const { return end_ - first_; }
  int size() const;
  double entries(const Ranks& ranks) const;
  Eigen::VectorXd diagonal() const; // own rows

  // Collective, own rows of A x, |A| |x|, and A x summed in extended precision: the terms of a thin
  // shell cancel to a billionth of their size.
  Eigen::MatrixXd operator*(const Eigen::MatrixXd& x) const;
  Eigen::MatrixXd absolute(const Eigen::MatrixXd& x) const;
  Eigen::MatrixXd exactly(const Eigen::MatrixXd& x) const;

  // A - sigma B, of the same pattern.
  DistributedMatrix minus(double sigma, const DistributedMatrix& B) const;

private:
  explicit DistributedMatrix(Mat mat);
  void prepare();
  template <class Sum, bool absolute_values>
  Eigen::MatrixXd product(const Eigen::MatrixXd& x) const;

  OwnedMat mat_;
  int first_ = 0, end_ = 0;
  // What the own rows meet of other ranks.
  mutable OwnedVec from_, ghosts_;
  OwnedScatter scatter_;
};

} // namespace plica

// Stiffness and mass over the independent DOFs: K = T' K_full T, M likewise, lower triangles.
//
// Elements are coloured so that those of one colour share no DOF; colours follow one another and
// the elements of one run in parallel, so the sums have one order whatever the number of threads:
// the result is bitwise the same.
#pragma once

#include "solve/constraints.hpp"
#include "solve/model.hpp"

#include <Eigen/SparseCore>

namespace plica {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

struct System {
  DofMap map;
  SparseMatrix K, M; // lower triangles, the same pattern
};

// Throws ConstraintError; std::invalid_argument from an element of no shape.
System assemble(const Model& model);

// The rows and columns of a lower triangle that are kept (kept: increasing numbers).
SparseMatrix restrict_to(const SparseMatrix& lower, const std::vector<int>& kept);

// Adds the lower triangle of a small dense matrix at the given DOFs (their entries must exist).
void add_dense(SparseMatrix& lower, const std::vector<int>& dofs, const Eigen::MatrixXd& block);

// Symmetric product with a matrix stored as lower triangle.
Eigen::MatrixXd symmetric_product(const SparseMatrix& lower, const Eigen::MatrixXd& x);

// Six rigid-body motions about a point, over the independent DOFs: ux uy uz rx ry rz.
Eigen::MatrixXd rigid_body_motions(const Model& model, const DofMap& map,
                                   const Eigen::Vector3d& about);

} // namespace plica

// Elimination of constraints: u = T q, q the independent DOFs.
//
// Each constraint makes its DOF dependent. Chains are followed to independent DOFs; a DOF that two
// rows determine, and rows that determine each other in a circle, are errors that name both rows.
// A DOF held at zero by two supports is held once.
#pragma once

#include "solve/model.hpp"

#include <stdexcept>

namespace plica {

struct ConstraintError : std::runtime_error {
  ConstraintError(const std::string& what, std::vector<Constraint> both)
      : std::runtime_error(what), rows(std::move(both)) {}
  std::vector<Constraint> rows; // the two
};

struct WeightedDof {
  int dof = 0; // independent
  double factor = 0;
};

struct DofMap {
  std::vector<int> independent; // per DOF: its number among the independent ones, or -1
  std::vector<std::vector<WeightedDof>> dependent; // per DOF: what a dependent one follows
  std::vector<int> first; // per node: number of its first independent DOF; one more at the end
  std::vector<int> full;  // per independent DOF: its number among all

  int size() const { return static_cast<int>(full.size()); }
};

// Throws ConstraintError.
DofMap eliminate(const Model& model);

// u = T q and its transpose, column by column.
Eigen::MatrixXd expand(const DofMap& map, const Eigen::MatrixXd& q);
Eigen::VectorXd gather(const DofMap& map, const Eigen::VectorXd& force);

} // namespace plica

// A direct solution of the whole mesh at single frequencies: neither modes, nor symmetry, nor
// superelements stand between it and the stiffness.
#pragma once

#include "run/analyses/sensor_model.hpp"
#include "solve/direct_response.hpp"

namespace plica {

// What is solved; all of it outlives the solution. Of the modes lambda, u over all DOFs and what
// damps them are taken.
struct DirectProblem {
  const BuiltCase& built;
  const Damping& damping;
  const DampedModes& modes;
  const Excitations& excited;
};

class DirectSolution {
public:
  explicit DirectSolution(const DirectProblem& problem);

  // Absolute acceleration of the channels, excitations x channels, from a factor of its own. Throws
  // std::runtime_error where the matrix is singular or memory is short.
  Eigen::MatrixXcd acceleration(double hertz) const;

private:
  void add_loss(const Damping& damping);
  void add_modal_damping(const DampedModes& modes);
  void add_forces();
  Eigen::VectorXd on_free(const Eigen::VectorXd& all) const;
  Eigen::VectorXcd load(int column, double omega) const;

  const BuiltCase& built_;
  const Excitations& excited_;
  System system_;
  std::vector<int> free_;
  SparseMatrix loss_; // over all independent DOFs
  DirectModel model_;
  Eigen::MatrixXd force_;
};

// Its answers at some frequencies, one matrix each.
using DirectSolver = std::function<std::vector<Eigen::MatrixXcd>(const DirectProblem& problem,
                                                                 const std::vector<double>& hertz)>;

// One after the other in this process.
std::vector<Eigen::MatrixXcd> solve_directly(const DirectProblem& problem,
                                             const std::vector<double>& hertz);

} // namespace plica

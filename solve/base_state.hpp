// The static state around which a model vibrates: large displacement and rotation, small strain.
//
// Newton's method on the equilibrium of all elements (elements/*_state.hpp,
// solve/state_elements.hpp) with the stiffness of the state itself; rotations are updated by R ->
// exp(theta) R, rigid couplings exactly, other constraints by their rows. The loads grow together
// from 0 to 1: all at once when that converges, in halved steps when not. Pressure and thermal
// strain are those of the sections of the model, which loads share.
#pragma once

#include "solve/acting_loads.hpp"

#include <functional>
#include <stdexcept>

namespace plica {

// One Newton step: the unbalanced forces -f of `now` over all DOFs, and how far each hold has still
// to go (six rows each), to increments of all DOFs.
struct StateIncrement {
  Eigen::VectorXd u;
  double residual = 0; // norm of what the free DOFs lack
  bool stable = true;  // the stiffness is positive definite
};
struct StateSolver {
  std::function<StateIncrement(const Model& now, const Eigen::VectorXd& unbalanced,
                               const Eigen::VectorXd& still_to_go)>
      step;
  // Forces of the elements as step() takes them: state_forces(), or of what stands for the whole.
  std::function<Eigen::VectorXd(const Model& now)> forces;
};

// One step on the unknowns of a system: those of `held` (in any order) go as `q` says, the others
// by what they lack; all stand in `q` then. Leaves `u` empty.
StateIncrement solve_increment(const SparseMatrix& K, const Eigen::VectorXd& lacking,
                               std::vector<int> held, Eigen::VectorXd& q);

// On the full mesh. `holds`: nodes.
StateSolver full_state_solver(std::vector<int> holds);

struct StateIteration {
  double share = 0;    // of the loads
  double residual = 0; // beside the forces that act
  double step = 0;     // largest displacement of the increment, m
};

struct BaseState {
  Model model;             // at the state
  Eigen::VectorXd lacking; // over all DOFs: what the loads do not balance, so what holds bears it
  std::vector<StateIteration> iterations;
  int load_steps = 0;
  double largest_displacement = 0; // m
  // Displacements of the linear solution against those of the state: norm of the difference / norm;
  // not a number where caps grow with heat.
  double linear_error = 0;
};

struct StateError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Throws StateError with the share of the loads at which it stopped, and why.
BaseState find_state(const Model& at_rest, const StateLoads& loads, const StateSolver& solver,
                     const std::function<void(const StateIteration&)>& progress);

} // namespace plica

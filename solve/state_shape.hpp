// Where the nodes of a model are and how far they have turned, on the way into a state.
#pragma once

#include "solve/acting_loads.hpp"

namespace plica {

// The model when its nodes are there, turned so, with couplings, arms and directors following, and
// its joints loaded for the first time; `share` of its pressure and thermal strain.
Model model_at(const Model& at_rest, std::vector<Eigen::Vector3d> nodes,
               std::vector<Eigen::Matrix3d> turned, double share);

// Nodes that follow another rigidly in all six DOFs, with that node; one that itself follows passes
// it on.
std::vector<std::pair<int, int>> rigid_followers(const Model& at_rest);

class StateShape {
public:
  // At rest; both must outlive it.
  StateShape(const Model& at_rest, const StateLoads& loads);

  Model model(double share) const; // at a share of the loads
  // Of each hold, six rows: to where it is at a share of the loads.
  Eigen::VectorXd still_to_go(double share) const;
  // Moves all nodes by u, over all DOFs, and those that follow others rigidly after them; what
  // follows a hot cap has the size of that share.
  void move_by(const Eigen::VectorXd& u, double share);

  const std::vector<Eigen::Vector3d>& nodes() const { return nodes_; }

private:
  const Model* rest_;
  const StateLoads* loads_;
  std::vector<std::pair<int, int>> followers_; // node, whom it follows
  std::vector<Eigen::Vector3d> nodes_;
  std::vector<Eigen::Matrix3d> turned_;
};

// Forces of constant direction: those given, and the weight of the masses; over all DOFs.
Eigen::VectorXd dead_loads(const Model& at_rest, const StateLoads& loads);

double size_of(const Model& model); // m, at least 1e-6
// Of forces over all DOFs, moments divided by the size.
double norm_of(const Eigen::VectorXd& force, double size);
double largest_move(const Eigen::VectorXd& u); // of a node, m
double largest_turn(const Eigen::VectorXd& u); // rad

// What follows a node rigidly is borne there by forces g at arms a, and turns about it on circles:
// that alone makes a stiffness sum (g a' + a g') / 2 - (g . a) I of its rotation, which no element
// has; here as elements of their own for a model at its state. `lacking`: forces over all DOFs that
// the loads do not balance (BaseState); `axisymmetric`: it is about y, to the last digit.
std::vector<MatrixElement> coupling_stiffness(const Model& now, const Model& at_rest,
                                              const Eigen::VectorXd& lacking, bool axisymmetric);

// Away from equilibrium the weak tie of the drilling rotation does not hold against moments that
// are not yet balanced. A stiffer one in the matrix of a step leaves the state as it is.
Model with_stiff_drilling(Model model);

} // namespace plica

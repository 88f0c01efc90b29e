// A structure with joints in the coordinates of its modes, the stiffness of the joints not among
// them, and what it does in harmonic n without them:
//
//   D(W) = diag(lambda_r (1 + i eta_r) - W^2 + 2 i zeta_r sqrt(lambda_r) W)
//          + sum_k b_k g_k(i W) b_k',    W = n omega
//
// b_k, g_k: damped springs (dissipation.hpp), linear and so exact in every harmonic; in a mean
// motion, W = 0, nothing damps.
#pragma once

#include "elements/joint_law.hpp"
#include "solve/dissipation.hpp"

namespace plica {

struct JointedStructure {
  Eigen::VectorXd lambda, zeta, eta; // of the modes: (rad/s)^2, fraction of critical, loss factor
  Eigen::MatrixXd joints;            // modes x joints: motion of each joint by each mode
  Eigen::VectorXd input;             // modal force per unit of the excitation, harmonic 1
  std::vector<JointLaw> laws;        // one per joint
  Eigen::MatrixXd dampers = {};      // modes x damped springs: relative motion that each feels
  std::vector<AddedStiffness> added = {}; // one per damped spring
};

// Added stiffness of every damped spring in harmonic n, and its derivative by omega.
Eigen::VectorXcd added_at(const JointedStructure& structure, int n, double omega);
Eigen::VectorXcd added_slope(const JointedStructure& structure, int n, double omega);

// D(n omega). The structure must outlive it.
class DynamicStiffness {
public:
  DynamicStiffness(const JointedStructure& structure, int n, double omega);

  Eigen::MatrixXcd solve(const Eigen::MatrixXcd& force) const;     // D^-1 f, columns
  Eigen::VectorXcd by_omega(const Eigen::VectorXcd& motion) const; // dD/domega q

private:
  const JointedStructure& s_;
  int n_;
  double omega_;
  Eigen::VectorXcd inverse_;    // of the diagonal
  Eigen::MatrixXcd of_springs_; // it times the dampers
  Eigen::MatrixXcd between_;    // (1 + G B' of_springs)^-1 G
};

} // namespace plica

// Joints behind a structure that is moved harmonically: what the joints feel of it is its
// receptance between them, harmonic by harmonic,
//
//   x_n = a x_free,n - G_n F_n(x),
//
// x the relative motions of the joints, x_free those without the forces F of the joints, a = 1.
// Unlike harmonic_balance.hpp it asks nothing of how the structure is damped.
#pragma once

#include "solve/joint_force.hpp"

#include <vector>

namespace plica {

struct MovedJoints {
  std::vector<JointLaw> laws;
  double omega = 0;                         // rad/s
  std::vector<Eigen::MatrixXcd> receptance; // of each order of the basis, joints x joints
  Eigen::VectorXcd free_motion;             // in harmonic 1; the others are at rest
};

struct BalancedJoints {
  bool converged = false;
  double residual = 0;    // relative to the motion
  Eigen::VectorXd motion; // joint by joint as in HarmonicBasis
  Eigen::VectorXcd force; // in harmonic 1, one per joint
};

// Newton's method from a guess (empty: all joints stuck), and where it fails from small motion up
// to this one.
BalancedJoints balance_joints(const MovedJoints& joints, const HarmonicBasis& basis,
                              const Eigen::VectorXd& guess, double tolerance);

} // namespace plica

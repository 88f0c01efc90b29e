// Periodic response of a structure with joints to a harmonic excitation, by harmonic balance with
// alternating frequency and time (AFT; Krack & Gross, Harmonic Balance for Nonlinear Vibration
// Problems, Springer 2019).
//
//   eta_r,n D_r(n w) = f_r,n - sum_j J_rj F_j,n(x),    x_j = sum_r J_rj eta_r,
//   D_r(W) = lambda_r (1 + i eta_r) - W^2 + 2 i zeta_r sqrt(lambda_r) W
//
// Only the relative motions x of the joints are unknown, with harmonics 0 to H; all else follows.
// x(t) = x_0 + Re sum x_n e^{i n w t}. The Jacobian is analytic, dry friction without
// regularisation.
#pragma once

#include "elements/joint_law.hpp"

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace plica {

// A structure in the coordinates of its modes, the stiffness of the joints not among them.
struct JointedStructure {
  Eigen::VectorXd lambda, zeta, eta; // of the modes: (rad/s)^2, fraction of critical, loss factor
  Eigen::MatrixXd joints;            // modes x joints: motion of each joint by each mode
  Eigen::VectorXd input;             // modal force per unit of the excitation, harmonic 1
  std::vector<JointLaw> laws;        // one per joint
};

struct HarmonicSettings {
  int harmonics = 5;
  int samples = 256;              // of a period; at least 2 (H + 1) + 1
  double tolerance = 1e-8;        // of the residual, relative to the linear motion
  int newton_steps = 20;
  double from = 0, to = 0;        // rad/s, upwards or downwards
  double first_step = 0;          // rad/s; 0 = a hundredth of the range
  double largest_step = 0;        // 0 = a fiftieth of the range
  int most_points = 2000;
  bool around_folds = true; // follow the branch by its arc length; else jump where it ends
};

struct PeriodicPoint {
  double omega = 0;
  Eigen::MatrixXcd joints; // harmonics 0..H x joints: relative motion
  Eigen::MatrixXcd modes;  // harmonics 0..H x modes
  int iterations = 0;
};

// Points along a branch; one that could not be followed to its end says where and why.
struct Branch {
  std::vector<PeriodicPoint> points;
  bool complete = false;
  std::string reason;
};

// At one frequency, from a guess of the joint motion (empty = all joints stuck).
struct PeriodicSolution {
  bool converged = false;
  PeriodicPoint point;
  double residual = 0;
};
PeriodicSolution periodic_response(const JointedStructure& structure, double omega, double level,
                                   const HarmonicSettings& settings,
                                   const Eigen::MatrixXcd& guess = {});

// Over frequency at a level.
Branch follow_frequency(const JointedStructure& structure, double level,
                        const HarmonicSettings& settings);

// Residual over the real unknowns (per joint x_0, Re x_1, Im x_1, ...) with its derivatives by them
// and by the frequency: for tests of the Jacobian.
struct HarmonicResidual {
  Eigen::VectorXd value;
  Eigen::MatrixXd by_motion;
  Eigen::VectorXd by_omega;
};
HarmonicResidual harmonic_residual(const JointedStructure& structure, double omega, double level,
                                   const HarmonicSettings& settings, const Eigen::VectorXd& motion);

} // namespace plica

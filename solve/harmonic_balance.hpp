// Periodic response of a structure with joints to a harmonic excitation, by harmonic balance with
// alternating frequency and time (Krack & Gross, Harmonic Balance for Nonlinear Vibration Problems,
// Springer 2019).
//
//   D(n w) q_n = f_n - sum_j J_j F_j,n(x),    x_j = J_j' q,    D: jointed_structure.hpp
// Only the relative motions x of the joints are unknown; all else follows. Laws that are odd move
// in the odd harmonics alone, so only these are taken then. The Jacobian is analytic, dry friction
// without regularisation. Angles and lengths meet in one norm: each joint is measured in the root
// of the energy in its static flexibility.
#pragma once

#include "solve/continuation.hpp"
#include "solve/joint_force.hpp"
#include "solve/joint_method.hpp"
#include "solve/jointed_structure.hpp"

namespace plica {

// Stiffness matrix over the modes with every joint stuck (of smoothed Coulomb friction: held by a
// thousand times the structure's own stiffness there).
Eigen::MatrixXd stuck_stiffness(const JointedStructure& structure);

struct HarmonicSettings {
  JointMethod method = JointMethod::harmonic_balance;
  int harmonics = 5;       // the highest; describing function: 1
  int samples = 256;       // of a period
  double tolerance = 1e-8; // of the residual, relative to the motion
  double from = 0, to = 0; // rad/s, or level, upwards or downwards
  double largest_step = 0; // 0 = a hundredth of the way
  int most_points = 5000;
};

struct PeriodicPoint {
  double omega = 0, level = 0;
  Eigen::MatrixXcd joints; // harmonics x joints: relative motion
  Eigen::MatrixXcd modes;  // harmonics x modes
  bool stable = true;      // against folds and branches of other symmetry (CurvePoint::same_side)
  int iterations = 0;
};

// Points along a branch; one that could not be followed to its end says where and why.
struct Branch {
  std::vector<int> orders; // harmonics
  std::vector<PeriodicPoint> points;
  bool complete = false;
  std::string reason;
};

// At one frequency, from a guess of the joint motion (harmonics x joints; empty = all joints
// stuck).
struct PeriodicSolution {
  std::vector<int> orders;
  bool converged = false;
  PeriodicPoint point;
  double residual = 0;
};
PeriodicSolution periodic_response(const JointedStructure& structure, double omega, double level,
                                   const HarmonicSettings& settings,
                                   const Eigen::MatrixXcd& guess = {});

// Over frequency at a level, and over the level at a frequency.
Branch follow_frequency(const JointedStructure& structure, double level,
                        const HarmonicSettings& settings);
Branch follow_level(const JointedStructure& structure, double omega,
                    const HarmonicSettings& settings);

// What a slow sweep over a branch sees: the points of the branch that it passes, and where it
// jumps. Frequencies increase, or decrease downwards.
struct Sweep {
  std::vector<std::size_t> points; // of the branch
  std::vector<double> jumps;       // rad/s
};
Sweep sweep_over(const Branch& branch, bool upwards);

// Energy that each joint takes in a cycle, J: the area of its loop, pi sum n Im(F_n x_n*).
Eigen::VectorXd cycle_energies(const JointedStructure& structure, const PeriodicPoint& point,
                               const std::vector<int>& orders);

// Damping of a point by its energy: what a cycle takes, by joints and modes, over 4 pi times the
// largest kinetic energy of the first harmonic.
double energy_damping(const JointedStructure& structure, const PeriodicPoint& point,
                      const std::vector<int>& orders);

// Residual over the real unknowns (joint by joint as in HarmonicBasis) with its derivatives by them
// and by the frequency: for tests of the Jacobian.
Residual harmonic_residual(const JointedStructure& structure, double omega, double level,
                           const HarmonicSettings& settings, const Eigen::VectorXd& motion);

} // namespace plica

// Dynamic stiffness of a part between two ends: force over displacement, 12 x 12, over frequency
// and, with friction, over the amplitude of the end that moves.
//
//   Z(w) = Z_bb - Z_bq Z_qq^-1 Z_qb
//   Z_bb = K_bb - w^2 M_bb + i L_bb + ...,   Z_bq = -w^2 M_bq + i L_bq + ...,
//   Z_qq = Lambda - w^2 + i w C + i L_qq + ...
//
// over the motion u_b of the ends and the modes q with both ends held, completed by static answers
// to the inertia of every motion of an end and to a unit force in every joint; "..." stands for
// dampers whose stiffness depends on frequency. In the words of ISO 10846-1: with end 2 held, the
// rows of end 1 by the motion of end 1 are the driving-point stiffness k_11, and less the rows of
// end 2, the blocking forces that the part exerts there, are the transfer stiffness k_21.
#pragma once

#include "elements/joint_law.hpp"

#include <Eigen/Core>
#include <array>
#include <complex>
#include <functional>
#include <string>
#include <vector>

namespace plica {

using Complex1212 = Eigen::Matrix<std::complex<double>, 12, 12>;

struct EndDamper {
  Eigen::VectorXd stretch; // by the ends' motions and the modes
  std::function<std::complex<double>(std::complex<double> s)> added; // stiffness, s = i omega
};

// ux uy uz rx ry rz of end 1, then of end 2, then the modes. SI.
struct PartBetweenEnds {
  std::array<std::string, 2> names;
  std::array<Eigen::Vector3d, 2> places;
  Eigen::Matrix<double, 12, 12> K, M; // static condensation, and its mass
  Eigen::MatrixXd M_bq;               // 12 x modes
  Eigen::VectorXd lambda, viscous;    // of the modes: (rad/s)^2, 2 zeta omega in rad/s
  Eigen::MatrixXd loss;               // L, over all coordinates; empty = none
  std::vector<EndDamper> dampers;
  Eigen::MatrixXd joints; // coordinates x joints: what each stretches a joint by
  std::vector<JointLaw> laws;
};

// Amplitudes of the end that moves: m and rad; zero = so small that every joint sticks.
struct MotionLevel {
  double translation = 0, rotation = 0;
};

struct StiffnessOverFrequency {
  Eigen::VectorXd hertz;
  std::vector<MotionLevel> levels;
  std::vector<std::vector<Complex1212>> at; // levels x frequencies; NaN = not found
  int not_found = 0;                        // columns without a solution
};

// Small motion: every joint sticks. Complex symmetric. At 0 Hz what does not depend on frequency
// stays: K, and as its imaginary part the loss.
Complex1212 dynamic_stiffness(const PartBetweenEnds& part, double hertz);

// First harmonic of the forces over the motion of one end coordinate at a time, the other ones
// held, by harmonic balance with harmonics up to `harmonics`.
StiffnessOverFrequency dynamic_stiffness(const PartBetweenEnds& part, const Eigen::VectorXd& hertz,
                                         const std::vector<MotionLevel>& levels, int harmonics,
                                         int samples);

// The connector in the middle between the ends, without mass, that has the transfer stiffness of Z:
// 6 x 6, relative motion of end 2 against end 1 there, Z_21 = -A_2' k A_1 with A_i from the motion
// of an end to that of the middle.
Eigen::Matrix<std::complex<double>, 6, 6> connector_in_middle(const Complex1212& Z,
                                                              const Eigen::Vector3d& end_1,
                                                              const Eigen::Vector3d& end_2);

// The part in one state.
struct StateStiffness {
  std::string name; // "at rest", "y 5 mm"
  PartBetweenEnds part;
  StiffnessOverFrequency over;
  std::string route;
  int modes = 0; // without the static answers
};

struct EndDynamicStiffness {
  std::string case_name;
  std::vector<StateStiffness> states;
  bool friction = false;
  std::vector<std::string> notes;
  double highest_mode = 0; // Hz, up to which modes were taken
};

// "left.x", "right.rz": the twelve coordinates.
std::vector<std::string> end_coordinate_names(const std::array<std::string, 2>& ends);

} // namespace plica

// Nonlinear modes of a structure with joints: frequency and damping against amplitude, by the
// extended periodic motion concept (Krack, Comput. Struct. 154 (2015) 59-71). A damping
// proportional to the mass feeds in what the structure takes, so that its motion is periodic:
//
//   M q'' + C q' + K q + f(q, q') - 2 zeta omega M q' = 0,   Q_1' M Q_1 = a^2
//
// zeta is the damping of the mode at amplitude a of its first harmonic, mass-normalised.
#pragma once

#include "solve/harmonic_balance.hpp"

namespace plica {

struct BackbonePoint {
  double amplitude = 0; // a, m sqrt(kg)
  double omega = 0, zeta = 0;
  Eigen::MatrixXcd modes; // harmonics x modes
};

struct Backbone {
  std::vector<int> orders;
  std::vector<BackbonePoint> points;
  bool complete = false;
  std::string reason;
};

struct BackboneSettings {
  int harmonics = 5, samples = 256;
  double from = 1e-6, to = 1e-2; // of a, followed over its logarithm
  double largest_step = 0.1;     // of log10 a
  double tolerance = 1e-8;
};

// Of the mode with every joint stuck, counted from 0 (Eigen vector over the modal coordinates).
Backbone backbone(const JointedStructure& structure, int mode, const BackboneSettings& settings);

// Frequencies ((rad/s)^2) and shapes over the modal coordinates with every joint stuck.
struct StuckModes {
  Eigen::VectorXd lambda;
  Eigen::MatrixXd shapes; // mass-normalised, modes x modes
};
StuckModes stuck_modes(const JointedStructure& structure);

} // namespace plica

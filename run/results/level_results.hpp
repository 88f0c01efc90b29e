// Responses at several levels of excitation: what friction makes of them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace plica {

// A maximum of a slow sweep that stands at least 3 % above the valleys beside it.
struct LevelPeak {
  int channel = 0;
  double frequency = 0, amplitude = 0; // Hz; first harmonic over the level
  double damping = 0;                  // half power; NaN where the curve has no flanks
  double energy_damping = 0;           // what a cycle takes / (4 pi kinetic energy)
};

struct JointMotion { // at the peak of the strongest channel
  std::string joint;
  double motion = 0; // largest amplitude of the first harmonic, m or rad
  double mean = 0;   // of the motion, against the state; 0 where laws are the same both ways
  double energy = 0; // that a cycle takes, J
};

struct LevelCurve {
  double level = 0;
  // Along the branch, which may turn back: points x channels.
  Eigen::VectorXd hertz;
  std::vector<bool> stable;
  Eigen::MatrixXcd first;                   // first harmonic of the acceleration over the level
  std::vector<int> orders;                  // the other harmonics
  std::vector<Eigen::MatrixXd> higher;      // amplitudes over the level, one per order
  std::vector<int> up, down;                // points that a slow sweep passes, in its order
  std::vector<double> jumps_up, jumps_down; // Hz
  std::vector<LevelPeak> peaks_up, peaks_down;
  std::vector<JointMotion> joints;
  bool complete = false;
  std::string reason; // why not, and where it ended
};

struct BackboneCurve {
  double stuck_frequency = 0; // Hz
  Eigen::VectorXd amplitude;  // of the strongest channel, m/s2
  Eigen::VectorXd frequency, damping;
  bool complete = false;
  std::string reason;
};

// The fast path beside the harmonic balance: relative error of the first peak of the strongest
// channel.
struct LinearisedError {
  double level = 0, frequency = 0, amplitude = 0;
};

struct RefereeCheck { // a point of the harmonic balance against integration in time
  double level = 0, frequency = 0;
  double difference = 0; // of the first harmonic, relative, over the channels
  bool settled = false;
};

struct LevelResponses {
  std::string excitation; // x y z rx ry rz, or the name of the force
  bool is_force = false;
  std::string unit;                         // of the level
  std::string method;                       // harmonic balance | describing function
  int harmonics = 0, joints = 0, modes = 0; // joints and modes that the excitation moves
  std::vector<std::pair<std::string, std::string>> channels; // sensor, axis
  std::vector<int> shown; // channels that are more than a thousandth of the largest
  int strongest = 0;      // channel
  std::vector<LevelCurve> curves;
  std::vector<BackboneCurve> backbones;
  std::vector<LinearisedError> linearised;
  std::vector<RefereeCheck> referee;
  double seconds = 0; // of all sweeps
};

// Both ends of what friction can do.
struct SlippingLimit {
  std::vector<std::string> joints; // places with friction or nonlinear springs
  double k_axial_stuck = 0;        // N/m; 0 = not two caps
};

} // namespace plica

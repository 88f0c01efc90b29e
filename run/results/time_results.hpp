// What transients and run-ups give (results.hpp): plain data, SI units, frequencies in Hz.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace plica {

struct Extreme {              // largest magnitude of a channel, with its sign
  double value = 0, time = 0; // m/s2, s
};

// Maximax shock response spectra.
struct ShockSpectra {
  double quality = 0;
  Eigen::VectorXd hertz, input; // input: of a base, empty for a force
  Eigen::MatrixXd channels;     // frequencies x channels, m/s2
};

// Absolute acceleration of the sensors in their own axes over time.
struct TransientResult {
  std::string name;
  std::string input_title; // "base y", "force tap"
  std::string unit;        // of the input: m/s2 rad/s2 N Nm
  double step = 0;         // s
  Eigen::VectorXd input;
  std::vector<std::pair<std::string, std::string>> channels; // sensor, axis: three per sensor
  Eigen::MatrixXd acceleration;                              // samples x channels, m/s2
  std::vector<int> shown;        // channels that reach a thousandth of the largest
  std::vector<Extreme> extremes; // per channel
  Eigen::VectorXd rms;           // per channel, over the whole time
  std::optional<ShockSpectra> spectra;
};

// All inputs of one order of the engine, amplitudes and phases of the sensors.
struct OrderCut {
  double order = 0;
  Eigen::MatrixXcd acceleration; // speeds or times x channels, m/s2
};

// The orders while the speed runs as given over time.
struct OrderSweeps {
  Eigen::VectorXd time, speed; // s, revolutions per second
  std::vector<OrderCut> orders;
  Eigen::MatrixXd overall; // RMS of all orders together, times x channels, m/s2
};

// Where an order runs through a mode.
struct OrderCrossing {
  double order = 0;
  int mode = 0; // of the results, from 0
  double speed = 0, frequency = 0;
  int channel = 0;      // that answers most there
  double amplitude = 0; // of it, m/s2
  // Speed of the sweep over the fastest that shows the whole peak (ISO 7626-2); none: not stated.
  std::optional<double> haste;
  std::optional<double> reached = {}; // amplitude of that channel in time, m/s2
};

// Steady response at every speed of an engine.
struct RunUpResult {
  std::string name;
  Eigen::VectorXd speed; // revolutions per second
  std::vector<std::pair<std::string, std::string>> channels;
  std::vector<int> shown;
  std::vector<OrderCut> orders;
  Eigen::MatrixXd overall;                // RMS of all orders together, speeds x channels, m/s2
  std::vector<OrderCrossing> crossings;   // by speed
  std::optional<OrderSweeps> sweeps = {}; // where the speed is given over time
};

} // namespace plica

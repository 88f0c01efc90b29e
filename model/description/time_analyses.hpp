// What is asked of a case over time and over the speed of an engine (analyses.hpp): transients,
// shocks, run-ups. Their inputs are excitations of the response, by name.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace plica {

// An evenly sampled signal in a file of a lab. In m/s2 or rad/s2 of a base, N or Nm of a force.
struct SampledSignal {
  std::string file;             // CSV, universal, MATLAB; relative to the case file
  std::string channel;          // of several
  std::optional<double> rate;   // Hz, of a file without times
  double factor = 1;            // times
  double step = 0;              // s, as read
  Eigen::VectorXd samples = {}; // as read, times the factor
};

// Shocks of IEC 60068-2-27.
enum class PulseShape { half_sine, sawtooth, trapezoid };

struct Pulse {
  PulseShape shape = PulseShape::half_sine;
  std::optional<double> acceleration; // peak, m/s2 (rad/s2), or
  std::optional<double> force;        // N (Nm)
  double duration = 0;                // s
};

struct SpectrumRequest {               // of the shock and of what the sensors feel
  std::array<double, 2> band{5, 2000}; // Hz
  int per_octave = 12;
  double quality = 10; // 1 / (2 zeta)
};

struct Transient {
  std::string name;
  std::string of; // "y", "engine_y" (a motion), "tap" (a force)
  std::optional<SampledSignal> signal;
  std::optional<Pulse> pulse;
  double after = 0; // s at rest behind the signal
  std::optional<SpectrumRequest> spectrum;
};

// One order of an engine on one input.
struct EngineOrder {
  double order = 0; // cycles per revolution
  std::string of;
  std::optional<double> acceleration, force; // the same at every speed, or
  std::vector<std::array<double, 2>> table;  // [revolutions per second, SI of the input]
  double phase = 0;                          // rad, ahead of the order's other inputs
};

struct RunUp {
  std::string name;
  std::array<double, 2> speed{};            // from, to, revolutions per second; or
  std::vector<std::array<double, 2>> table; // [s, revolutions per second]
  int points = 400;
  std::vector<EngineOrder> orders;
};

// Lowest and highest speed, revolutions per second.
std::array<double, 2> speeds(const RunUp& run_up);

// A table of [x, y] with increasing x at x, straight between its rows and level beyond them.
double table_at(const std::vector<std::array<double, 2>>& table, double x);

} // namespace plica

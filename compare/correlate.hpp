// Simulation and test side by side: modes paired, shapes and responses compared, with what the
// sensors of the test cannot tell.
#pragma once

#include "lab/measured/test_data.hpp"

#include <Eigen/Core>

namespace plica {

struct PairedMode {
  int simulated = 0, measured = 0;        // indices of the modes of both sides
  double frequency_error = 0;             // simulated / measured - 1
  std::optional<double> frequency_sigmas; // error in standard deviations, where one is stated
  std::optional<double> damping_error, damping_sigmas;
  std::optional<double> mac; // over the common channels
  std::string by;            // "shape" (MAC), "name" (kind, direction, order)
};

struct ComparedResponse {
  std::string response, reference;
  std::optional<double> level;
  double low = 0, high = 0; // common band, Hz
  double frac = 0;
  double best_frac = 0, stretch = 0; // frequencies of the simulation times 1 + stretch
  Eigen::VectorXd hertz;             // lines of the test in the band
  Eigen::VectorXcd simulated, measured;
};

// Of all responses to one reference, per line of the test.
struct ComparedLines {
  std::string reference;
  Eigen::VectorXd hertz, csac, csf;
};

struct ComparedNumber {
  std::string quantity, unit;
  double simulated = 0, measured = 0;
  std::optional<double> sigma;
};

struct Correlation {
  std::vector<PairedMode> pairs;
  std::vector<int> unpaired_measured, unpaired_simulated;
  std::vector<std::string> channels; // common ones of the shapes
  Eigen::MatrixXd mac;               // simulated x measured modes that have a shape; empty without
  Eigen::MatrixXd auto_mac;          // of the measured ones
  std::vector<int> mac_rows, mac_columns; // indices of these modes
  Eigen::VectorXd comac;                  // per channel, over the pairs
  std::vector<ComparedResponse> responses;
  std::vector<ComparedLines> lines;
  std::vector<ComparedNumber> numbers; // mass, static stiffness
  std::vector<std::string> limits;     // what these data cannot tell, in words
};

// Modes are paired by MAC above 0.5 where both have shapes over two channels or more (the best sum
// of MAC less ten times the squared relative difference of frequency, each mode once), else by
// kind, direction and order.
Correlation correlate(const TestData& simulated, const TestData& measured);

} // namespace plica

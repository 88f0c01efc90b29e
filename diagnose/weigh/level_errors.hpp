// How well the levels of excitation are known (`level_sigma` of a test).
#pragma once

#include "diagnose/readings/reading.hpp"

#include <Eigen/Core>

#include <vector>

namespace plica {

// Adds to the covariance S of the readings what they shift by where the level of their run is off,
// all readings of a run together. `series`: which readings are of one thing over the level.
void add_error_of_levels(const TestReadings& test, const std::vector<int>& series,
                         Eigen::MatrixXd& S);

} // namespace plica

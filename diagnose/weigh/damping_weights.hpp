// How readings answer to the damping of each mode:
//
//   W(i, m) = d ln reading_i / d ln zeta_m
//
// of the nominal structure, by the model itself: 1 for the damping of a peak, nearly -1 for its
// height, 0 at an end that the table holds, and for what shows along other axes what the modes in
// it make of it. Frequencies, mass and static stiffness count as if they did not feel it.
#pragma once

#include "diagnose/predict/nominal.hpp"

namespace plica {

// Readings x modes. Modes of other states of the specimen are those of the first that they are
// like, else stand for themselves.
Eigen::MatrixXd damping_weights(const Nominal& nominal, const TestReadings& test);

} // namespace plica

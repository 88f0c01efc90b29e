// Numbers that compare shapes and frequency responses.
//
//   MAC     |a' b|^2 / (a' a  b' b)                    Allemang, Sound and Vibration 37 (2003)
//   14-23 COMAC   per channel, over pairs of modes: (sum |a_q conj b_q|)^2 / (sum |a_q|^2 sum
//   |b_q|^2) FRAC    per channel, over frequency: |sum a conj b|^2 / (sum |a|^2 sum |b|^2) CSAC per
//   frequency, over channels: |a' b|^2 / (a' a  b' b) CSF     per frequency, over channels: 2 |a'
//   b| / (a' a + b' b)
//
// All lie in [0, 1]; CSF alone sees a difference of size.
#pragma once

#include <Eigen/Core>

namespace plica {

double mac(const Eigen::VectorXcd& a, const Eigen::VectorXcd& b);

// Columns are shapes: modes of a x modes of b.
Eigen::MatrixXd mac_matrix(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b);

// Columns are paired shapes; one number a row (channel).
Eigen::VectorXd comac(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b);

// frequencies x channels on both sides.
Eigen::VectorXd frac(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b); // per channel
Eigen::VectorXd csac(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b); // per frequency
Eigen::VectorXd csf(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b);  // per frequency

// How much of a shape lies on one line of the complex plane, 1 = real up to a factor (modal phase
// collinearity; Pappa and Ibrahim 1985).
double phase_collinearity(const Eigen::VectorXcd& shape);

// The shape turned so that its components lie along the real axis as well as they can, the largest
// positive; not scaled.
Eigen::VectorXcd turned_real(const Eigen::VectorXcd& shape);

} // namespace plica

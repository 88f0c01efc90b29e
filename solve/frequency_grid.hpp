// Frequencies at which a response is computed.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace plica {

// `points` equal steps over [low, high] Hz, every eigenfrequency in the band, and around each a
// cluster f +- zeta f sinh(0.08 i): twelve points within the half-power bandwidth, then each 8 %
// farther off than the last until the even steps are as fine. Increasing, no repeats.
Eigen::VectorXd frequency_grid(double low, double high, int points, const Eigen::VectorXd& hertz,
                               const Eigen::VectorXd& zeta);

} // namespace plica

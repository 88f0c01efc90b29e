// Measured responses that a fit is held against, line by line.
#pragma once

#include "lab/measured/frf_set.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace plica {

struct FitCurve { // a measured response to motion of the base
  std::string name, reference, response;
  std::vector<double> hertz, log_magnitude, sigma; // sigma relative
};

// Frequencies and magnitudes of a curve in simulated responses; none where they lack it.
std::optional<std::pair<Eigen::VectorXd, Eigen::VectorXd>>
magnitudes(const std::vector<FrfSet>& simulated, const FitCurve& curve);

// ln of computed over measured magnitude on the lines of a curve.
Eigen::VectorXd log_ratios(const FitCurve& curve, const Eigen::VectorXd& hertz,
                           const Eigen::VectorXd& magnitude);

} // namespace plica

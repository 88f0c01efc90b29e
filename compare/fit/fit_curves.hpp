// Magnitudes of computed responses on the lines of measured ones.
#pragma once

#include "compare/fit/fit_problem.hpp"

namespace plica {

// Frequencies and magnitudes of a curve in simulated responses; none where they lack it.
std::optional<std::pair<Eigen::VectorXd, Eigen::VectorXd>>
magnitudes(const std::vector<FrfSet>& simulated, const FitProblem::Curve& curve);

// ln of computed over measured magnitude on the lines of a curve.
Eigen::VectorXd log_ratios(const FitProblem::Curve& curve, const Eigen::VectorXd& hertz,
                           const Eigen::VectorXd& magnitude);

// Ties that leave the range of their number, in words; empty = none.
std::string bad_tie(Case& design, const FitRequest& request);

} // namespace plica

// What every search for modes takes, on one machine or over ranks.
#pragma once

#include <Eigen/Core>

namespace plica {

constexpr int guard_modes = 4; // computed beyond those asked for, to find a gap

double eigenvalue(double hertz); // (2 pi f)^2

// Order of magnitude of the largest eigenvalue: the median of K_ii / M_ii over what has mass, which
// a few stiff springs do not move. 0: nothing has mass.
double median_ratio(const Eigen::VectorXd& K_diagonal, const Eigen::VectorXd& M_diagonal);

} // namespace plica

// Points spread evenly over a box, without chance.
#pragma once

#include <Eigen/Core>

namespace plica {

// Number `index` from 0 of the Halton sequence in |z| < reach (Num. Math. 2 (1960) 84).
Eigen::VectorXd spread_point(int index, Eigen::Index dimensions, double reach);

} // namespace plica

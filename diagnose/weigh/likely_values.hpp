// The values that are told of a fitted hypothesis.
//
// Where a hypothesis acts anywhere along a part, its place and its size lie on a ridge: a soft
// support far out answers as a stiff one nearer to the clamp. The top of the ridge is where the
// readings are met best, which is not where the place most probably is, whatever the size. So,
// where there are draws of the posterior, the place is where they are densest (a Gaussian kernel,
// Silverman 1986, eq. 3.31, made narrower about the densest place until it stays), and the other
// values are medians of the draws near it.
#pragma once

#include "diagnose/weigh/hypothesis_fit.hpp"

namespace plica {

// In the order of the member's parameters, SI. Without draws, or without a place along a part: the
// optimum.
Eigen::VectorXd likely_values(const HypothesisFit& fit, std::size_t member);

} // namespace plica

// The 90 % interval of a fitted parameter.
#pragma once

#include "diagnose/weigh/evidence.hpp"

namespace plica {

// Of the draws where there are some, else of the Gaussian at the optimum. Fits of the same effect
// at the same place in other ways count by their evidence: what a dent has lost is less certain
// than it would be if its direction were known. Equal tails; of a parameter between two bounds the
// shortest interval, which ends at a bound where the draws crowd there. The numbers of a law of
// slip (Hypothesis::law_error) are those of that law: their interval is twice as wide.
struct Interval {
  std::array<double, 2> ends{};
  double middle = 0; // as probably above as below
};
Interval interval_of(const std::vector<const HypothesisFit*>& ways, Eigen::Index parameter,
                     const Prior& prior);

} // namespace plica

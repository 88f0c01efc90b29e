// Two of one effect on one part, two masses on a beam: one hypothesis twice in a set, at two
// places.
//
// Which of them is the first nothing says. The order is that of their places at the optimum, so
// that each has an interval of its own. Laplace's ln Z counts one of the two orders, chains that
// swap count both: ln 2 more at most.
#pragma once

#include "diagnose/weigh/hypothesis_fit.hpp"

namespace plica {

using Members = std::vector<const Hypothesis*>;

// Whether it may be in a set once more: its place moves, and it is there once at most.
bool may_be_twin(const Hypothesis& h, const Members& set);
bool ends_with_twin(const Members& set);

// The set without these; of twins as many go as are named.
Members without(Members set, const Members& these);

// Coordinates with twins in the order that they have at the optimum of the fit.
Eigen::VectorXd in_order_of(const HypothesisFit& fit, Eigen::VectorXd z);

} // namespace plica

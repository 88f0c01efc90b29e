// What acts anywhere on a part, looked at from outside.
#pragma once

#include "diagnose/effects/anywhere.hpp"

#include <gtest/gtest.h>

namespace plica {

// At a place, of DOFs that are given.
template <class Given>
double motion_of(const MovingMotion& motion, const Eigen::VectorXd& place, const Given& given) {
  const Eigen::VectorXd factors = motion.factors(place);
  EXPECT_EQ(factors.size(), Eigen::Index(motion.terms.size()));
  double moved = 0;
  for (std::size_t i = 0; i < motion.terms.size(); ++i)
    moved += factors[Eigen::Index(i)] *
             given(motion.terms[i].term->nodes.front(), motion.terms[i].term->dof);
  return moved;
}

} // namespace plica

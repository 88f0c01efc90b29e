// How stiff a joint is in a motion, as a hypothesis says it.
#pragma once

#include "diagnose/effects/joint_groups.hpp"

namespace plica {

// By "ratio" to what the case draws; of clamps that it draws as rigid by the "stiffness" of each,
// N/m or Nm/rad. One `unit` of the parameter is a share of the group's springs.
struct JointSize {
  EffectParameter parameter;
  double unit = 1, share = 1;
  double units(double value) const { return value / unit; }
};

// `stiffness`: of the group in this motion (stiffness_in); `ratio`: the prior of what the group has
// in terms of that.
JointSize joint_size(const JointGroup& group, JointDirection motion, double stiffness,
                     const Prior& ratio);

} // namespace plica

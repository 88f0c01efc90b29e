#include "diagnose/effects/joint_size.hpp"

namespace plica {

// The share is what the prior expects, so that a unit of a rigid clamp is of the size of what
// stands beside it, and not of the number that stands for rigid.
JointSize joint_size(const JointGroup& group, JointDirection motion, double stiffness,
                     const Prior& ratio) {
  if (!group.rigid) return {.parameter = {"ratio", "", ratio}};
  const double each = stiffness * double(group.bushings.size()); // they are alike
  Prior own = ratio;
  own.centre *= each;
  return {.parameter = {"stiffness", turns(motion) ? "Nm/rad" : "N/m", own},
          .unit = own.centre,
          .share = ratio.centre};
}

} // namespace plica

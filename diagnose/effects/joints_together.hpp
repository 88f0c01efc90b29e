// All joints of a structure as one cause.
#pragma once

#include "diagnose/effects/joint_groups.hpp"

namespace plica {

// Where there are several joints of springs, as the coils of a liner are: a group of all of them,
// at "joints", as stiff as they are in a row, with what it is made of. Clamps that are drawn as
// rigid are another, at "clamps".
struct JointsTogether {
  JointGroup group;
  std::vector<std::string> places;
};
std::vector<JointsTogether> joints_together(const std::vector<JointGroup>& groups);

} // namespace plica

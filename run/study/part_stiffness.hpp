// Dynamic stiffness of a case between two of its ends.
#pragma once

#include "model/description/case.hpp"
#include "reduction/dynamic_stiffness.hpp"
#include "run/stages.hpp"

namespace plica {

// The first end against the second, from where the state of the case has it.
struct OffsetOfEnd {
  int direction = 0; // 0..5 = x y z rx ry rz
  double value = 0;  // m or rad; 0 = the state of the case itself
};

struct StiffnessRequest {
  std::vector<std::string> ends;   // names of two caps; none = those of the case
  Eigen::VectorXd hertz;           // increasing, >= 0
  std::vector<MotionLevel> levels; // increasing, without that of small motion
  std::vector<std::string> states; // named ones of the case, "" = its own; none = its own alone
  std::vector<OffsetOfEnd> shifts; // from each of these states; none = as they are
  int harmonics = 5, samples = 256;
  double highest = 0; // Hz, beyond hertz, where the part is asked again later
};

// Both ends are held rigidly, whatever the mount of the case, and moved one coordinate at a time.
// Modes up to three times the highest frequency, where the third harmonic of a joint is, and static
// answers to all that acts. Small motion first, then the levels where anything in the case
// depends on them. With friction a state moves the part with its joints slipping: their forces act
// about it and not in it. Throws InputError for ends and states that are not there, further mounts,
// a state that is not one of held ends, and states with springs whose force depends on where they
// are; StateError, which begins with the name of the state, where there is no equilibrium.
EndDynamicStiffness part_stiffness(const Case& data, const StiffnessRequest& request,
                                   const StageListener& stage);

} // namespace plica

// A part whose mounted caps move, slowly, the others at rest.
//
// With R the static field of a moved cap, K R = 0 over the free DOFs but for the springs of a moved
// spring mount. The absolute motion under an acceleration a of that cap is R a and what moves
// against it, K u + M u'' = -M R a: with all caps moved together R is the rigid motion and this is
// motion of the base (solve/base_motion.hpp).
#pragma once

#include "model/shape/built_case.hpp"

#include <Eigen/Core>

namespace plica {

struct MovedCap {
  std::string cap;
  int direction = 0; // 0..5 = x y z rx ry rz, rotations about its reference node
};

// All DOFs x moved caps: the field when the mount of one cap moves by one (m or rad); of a spring
// mount, the ground behind the springs. Throws ModelError for a part that nothing else holds.
Eigen::MatrixXd fields_of_moved_caps(const BuiltCase& built, const std::vector<MovedCap>& moved);

} // namespace plica

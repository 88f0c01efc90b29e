// The loads by which a motion of the base as a rigid body acts, six directions; the response to
// them is frequency_response.hpp's.
//
// The held DOFs follow r_1..6 (translations along x y z, rotations about axes through a point) with
// acceleration a; the free ones are r a plus what they move against the base:
//   K u_rel + M u_rel'' = -(M r) a   over the free DOFs, with the mass that couples them to the
//   held
#pragma once

#include "solve/assembly.hpp"

namespace plica {

struct BaseMotion {
  Eigen::MatrixXd r;     // all independent DOFs x 6
  Eigen::MatrixXd force; // free DOFs x 6: -(M r), per unit acceleration
};

// `free`: numbers of the free DOFs among the independent ones, increasing.
BaseMotion base_motion(const Model& model, const System& system, const std::vector<int>& free,
                       const Eigen::Vector3d& about);

} // namespace plica

// Spring or bushing: a full 6x6 law between two nodes, or between a node and the ground.
//
//   f = S (u2 - u1)   in the axes of the columns of `axes`; the same form serves stiffness (N/m,
// Nm/rad, coupling terms) and viscous damping. The law acts at `point`, to which each node is tied
// rigidly, so that a rigid motion of both nodes stores no energy wherever they lie.
#pragma once

#include "elements/beam_timoshenko.hpp"
#include "elements/rigid_mass.hpp"

namespace plica {

struct Bushing {
  Matrix6 law = Matrix6::Zero(); // symmetric; ux uy uz rx ry rz along the axes below
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); // columns: local axes in global ones
  // At a state: what it bears beside its law, along the axes.
  Eigen::Matrix<double, 6, 1> preload = Eigen::Matrix<double, 6, 1>::Zero();
};

// Between two nodes, law at `point`. 12x12, global axes.
Matrix12 bushing_matrix(const Bushing& bushing, const Eigen::Vector3d& node1,
                        const Eigen::Vector3d& node2, const Eigen::Vector3d& point);

// Between a node and the ground, law at the node. 6x6, global axes.
Matrix6 ground_bushing_matrix(const Bushing& bushing);

} // namespace plica

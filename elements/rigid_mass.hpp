// Point mass or rigid body on one node: mass, offset of its centre, inertia about its centre.
//
//   M = [ m I        -m [c]x            ]
//       [ m [c]x      J - m [c]x [c]x   ]     [c]x: cross-product matrix of the offset c
//
// DOF order ux uy uz rx ry rz, global axes.
#pragma once

#include <Eigen/Core>

namespace plica {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

struct RigidMass {
  double mass = 0;                                   // kg
  Eigen::Vector3d offset{0, 0, 0};                   // node to centre of mass, m
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero(); // about the centre of mass, kg m2
};

// No negative mass, and an inertia that a body can have.
bool is_body(const RigidMass& body);

Matrix6 rigid_mass_matrix(const RigidMass& body);

} // namespace plica

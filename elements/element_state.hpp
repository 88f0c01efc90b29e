// An element at a state of finite displacement and rotation: what its nodes have done, the forces
// it exerts on them, and its stiffness to further motion.
//
// Increments are those of elements/strain_forms.hpp: displacements, and rotations that follow the
// rotation reached, both in global axes.
#pragma once

#include <Eigen/Core>

#include <array>

namespace plica {

// Of one element: rotation of each node since rest.
template <int nodes> using NodeRotations = std::array<Eigen::Matrix3d, nodes>;

// What of the stiffness is asked for: all of it, or what stress alone adds to it (buckling).
enum class StiffnessPart { all, by_stress };

// Without stress at rest, `force` = dW/dq and K = d2W/dq2 of the strain energy W. N, N m; N/m, ...
template <int dofs> struct ElementTangent {
  Eigen::Matrix<double, dofs, dofs> K;
  Eigen::Matrix<double, dofs, 1> force;
};

} // namespace plica

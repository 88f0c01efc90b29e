// Stiffness of a wall of any plies by MITC4 and MITC3+: one law for forces and moments per length.
//
//   n = t A e + t^2 B k,   m = t^2 B e + t^3/12 D k,   q = t S gamma
//
// e, k and gamma are membrane strain, curvature and transverse shear of the mid-surface as the two
// elements interpolate them (elements/shell_mitc4.hpp, shell_mitc3.hpp), (11, 22, 12) and (13, 23),
// in the axes of the wall: 1 is a given direction seen along the normal. t is the thickness at the
// point. For A = D of one isotropic material, B = 0 and S = 5/6 G a flat element is the very one of
// shell_mitc4_stiffness and shell_mitc3_stiffness; of a curved one terms of t over its radius of
// curvature are left out here.
#pragma once

#include "elements/membrane_strain.hpp"
#include "elements/shell_geometry.hpp"

#include <Eigen/Core>

namespace plica {

struct ShellLaminate {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero(), B = A, D = A; // Pa
  Eigen::Matrix2d S = Eigen::Matrix2d::Zero();               // Pa
  double rho = 0;                                            // kg/m3, mean over the thickness
  double drilling = 0;                                       // Pa, of the drilling tie
};

// The law in axes that lie `angle` before its own: axis 1 of the wall is at +angle in them.
ShellLaminate turned(const ShellLaminate& wall, double angle);

// Strain along axes at +angle from that along axes at 0: (11, 22, 12), the last an angle.
Eigen::Matrix3d strain_turn(double angle);

// `along`: axis 1 of the wall once it is projected on the element; not along the normal. N/m, N,
// N m; DOFs as those of the elements.
Eigen::Matrix<double, 24, 24> shell_laminate_stiffness(const ShellGeometry& geometry,
                                                       const ShellLaminate& wall,
                                                       const Eigen::Vector3d& along,
                                                       MembraneStrain membrane);
Eigen::Matrix<double, 18, 18> shell_laminate_stiffness(const TriangleGeometry& geometry,
                                                       const ShellLaminate& wall,
                                                       const Eigen::Vector3d& along);

} // namespace plica

// MITC4: four-node degenerated shell with assumed transverse shear (Dvorkin & Bathe, Eng. Comput. 1
// (1984) 77-88), six degrees of freedom per node.
//
//   x(r,s,z) = sum N_i (X_i + z V_i),   u(r,s,z) = sum N_i (u_i + z theta_i x V_i)
//
// V_i are the exact unit directors at the corners, z the distance from the mid-surface in m. The
// covariant strains in the plane are quadratic in z (constant part: membrane); the transverse shear
// is tied at the middle of the edges (Dvorkin & Bathe, eq. 10).
// Stress follows in a Cartesian basis whose third axis is the normal of the lamina z = const. 2x2x2
// Gauss points, with the metric at each z: walls whose thickness is a third of their radius of
// curvature are common here, and a mid-surface metric is then 1 % too soft. Slipping plies bend
// about their own mid-surfaces: the points through the thickness move in by sqrt(bending_factor).
//
// Membrane strains, by choice (Membrane in the section of the model):
//   displacement   from the bilinear displacements, as in the first MITC4
//   mitc4_plus     assumed (Ko, Lee & Bathe, Comput. Struct. 182 (2017) 404-418, eq. 26): does not
//                  lock when the element is warped; the same as `displacement` when it is flat
//   incompatible   four internal modes, r and s in each normal strain and in shear (Simo & Rifai,
//                  IJNME 29 (1990) 1595-1638; Taylor, Beresford & Wilson 1976), condensed: bends in
//                  its plane without parasitic shear. The interpolated director is shorter than one
//                  between the corners of an arc, which thins the wall of the other two by
//                  (turn of the normal)^2 / 8; here the wall keeps its thickness
//
// The drilling rotation is tied to the rotation of the membrane, (e2.u,1 - e1.u,2)/2, by a penalty
// of `drilling` G t; no spring to ground. DOF order per node: ux uy uz rx ry rz (global axes).
// Mass: consistent, with rotary inertia; the drilling rotation of a corner has none.
#pragma once

#include "elements/membrane_strain.hpp"
#include "elements/shell_geometry.hpp"
#include "elements/shell_lamina.hpp"
#include "elements/shell_section.hpp"

#include <Eigen/Core>
#include <vector>

namespace plica {

using Matrix24 = Eigen::Matrix<double, 24, 24>;

// e3 normal to the lamina, e1 along the middle of the element from edge r = -1 to r = 1.
using ShellStrainMatrix = ShellStrain<24>;
using ShellPoint = ShellSample<24>;

// At r, s in [-1, 1] and z in m; includes the condensed internal modes.
ShellStrainMatrix shell_mitc4_strain(const ShellGeometry& geometry, const ShellSection& section,
                                     MembraneStrain membrane, double r, double s, double z);

// The 2x2x2 integration points.
std::vector<ShellPoint> shell_mitc4_points(const ShellGeometry& geometry,
                                           const ShellSection& section, MembraneStrain membrane);

// N/m, N, N m.
Matrix24 shell_mitc4_stiffness(const ShellGeometry& geometry, const ShellSection& section,
                               MembraneStrain membrane);

// kg, kg m, kg m2.
Matrix24 shell_mitc4_mass(const ShellGeometry& geometry, const ShellSection& section);

// In-plane stress at the four corners, on the face below (-director) and above (+director) each, in
// global axes: rows xx yy zz xy yz zx of corner 1 below, corner 1 above, corner 2 below, ... Pa.
// The transverse shear vanishes at a face. Slipping plies: the outermost fibre of the bending of
// one of n equal plies, t/2 sqrt(bending_factor) from the middle; for a partial bond or unequal
// plies that is an equivalent.
Eigen::Matrix<double, 48, 24> shell_mitc4_face_stress(const ShellGeometry& geometry,
                                                      const ShellSection& section,
                                                      MembraneStrain membrane);

// Consistent nodal forces of a load per unit area, constant vector (N/m2) in global axes.
Eigen::Matrix<double, 24, 1> shell_mitc4_area_load(const ShellGeometry& geometry,
                                                   const Eigen::Vector3d& load);

} // namespace plica

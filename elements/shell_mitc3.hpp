// MITC3+: three-node degenerated shell with a bubble for the rotations and assumed transverse shear
// (Lee, Lee & Bathe, Comput. Struct. 138 (2014) 12-23), six degrees of freedom per node.
//
//   x = sum h_i (X_i + z V_i),   u = sum h_i (u_i + z theta_i x V_i) + z f_4 w
//   h = (1 - r - s, r, s),  f_4 = 27 r s (1 - r - s),  w in the plane across the mean director
//
// The two amplitudes of the bubble are condensed. Transverse shear is tied at six points (eq. 18
// there, d = 1e-4): the same whichever corner is first, and passes the patch tests. Everything else
// is that of MITC4 (elements/shell_mitc4.hpp): exact directors, metric at each z, plies that slip,
// drilling tie, mass; the wall keeps its thickness between corners whose directors differ.
//
// Limit: the membrane is that of the constant-strain triangle, which is stiff where the wall bends
// in its own plane or a curved wall bends without stretching; use quads where one may.
#pragma once

#include "elements/shell_geometry.hpp"
#include "elements/shell_lamina.hpp"
#include "elements/shell_section.hpp"

#include <vector>

namespace plica {

using Matrix18 = Eigen::Matrix<double, 18, 18>;

// Integration points: six in the plane, exact to the fourth degree (Dunavant, IJNME 21 (1985)
// 1129-1148), by two through the wall. Strains include the condensed bubble.
std::vector<ShellSample<18>> shell_mitc3_points(const TriangleGeometry& geometry,
                                                const ShellSection& section);

// N/m, N, N m. DOF order per node: ux uy uz rx ry rz (global axes).
Matrix18 shell_mitc3_stiffness(const TriangleGeometry& geometry, const ShellSection& section);

// kg, kg m, kg m2.
Matrix18 shell_mitc3_mass(const TriangleGeometry& geometry, const ShellSection& section);

// In-plane stress at the three corners, below and above each, as shell_mitc4_face_stress. Pa.
Eigen::Matrix<double, 36, 18> shell_mitc3_face_stress(const TriangleGeometry& geometry,
                                                      const ShellSection& section);

} // namespace plica

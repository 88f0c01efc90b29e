// MITC4 at a state of finite displacement and rotation, small strain: total Lagrangian, Green
// strain in covariant components (Dvorkin & Bathe, Eng. Comput. 1 (1984) 77-88; for MITC4+ Ko, Lee
// & Bathe, Comput. Struct. 185 (2017) 1-14, with the ties of the shape at rest), law of the wall
// between it and the second Piola-Kirchhoff stress.
//
//   2 E_ab = g_a . g_b - G_a . G_b,   g_a of x = sum N_i (x_i + z R_i V_i), G_a of the shape at
//   rest
//
// A thermal strain a makes lengths without stress (1 + a) as long, through the wall too: G_a . G_b
// then counts (1 + a)^2 times, and energy and stress are those of lengths that have grown. The
// incompatible modes are added to the Green strain and condensed; they follow from the
// displacements without an iteration. The drilling rotation is tied to that of the membrane,
// (t2.x,1 - t1.x,2)/2 with the tangents t = sum N_i R_i e. At rest it is elements/shell_mitc4.hpp.
#pragma once

#include "elements/element_state.hpp"
#include "elements/shell_mitc4.hpp"

namespace plica {

// `rest`: shape at rest; `now`: corners and directors at the state, whose directors are those at
// rest turned by `turned`.
ElementTangent<24> shell_mitc4_tangent(const ShellGeometry& rest, const ShellGeometry& now,
                                       const NodeRotations<4>& turned, const ShellSection& section,
                                       MembraneStrain membrane,
                                       StiffnessPart part = StiffnessPart::all);

// Stress of the state, as shell_mitc4_face_stress, in global axes of the shape now. Pa.
Eigen::Matrix<double, 48, 1> shell_mitc4_state_stress(const ShellGeometry& rest,
                                                      const ShellGeometry& now,
                                                      const ShellSection& section,
                                                      MembraneStrain membrane);

} // namespace plica

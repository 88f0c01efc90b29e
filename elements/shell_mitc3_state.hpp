// MITC3+ at a state of finite displacement and rotation, as elements/shell_mitc4_state.hpp: Green
// strain, the transverse shear tied as at rest. The bubble is small beside its corners: its strain
// is that of the shape at rest, added to the Green strain and condensed.
#pragma once

#include "elements/element_state.hpp"
#include "elements/shell_mitc3.hpp"

namespace plica {

ElementTangent<18> shell_mitc3_tangent(const TriangleGeometry& rest, const TriangleGeometry& now,
                                       const NodeRotations<3>& turned, const ShellSection& section,
                                       StiffnessPart part = StiffnessPart::all);

// Stress of the state, as shell_mitc3_face_stress, in global axes of the shape now. Pa.
Eigen::Matrix<double, 36, 1> shell_mitc3_state_stress(const TriangleGeometry& rest,
                                                      const TriangleGeometry& now,
                                                      const ShellSection& section);

} // namespace plica

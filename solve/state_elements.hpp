// Elements of a model at a state (Model::rest): forces on their nodes and stiffness to further
// motion, elastic and of the pressure.
//
// Pressure has a potential, -p V, as far as the wall and its pressed ends close a volume V: on a
// quad V = 1/3 int x . (x,r x x,s) dr ds over the mid-surface, on an end x . a / 3. Its forces
// follow the wall, and its stiffness is symmetric; of an open surface both would depend on the
// origin.
#pragma once

#include "elements/element_state.hpp"
#include "solve/model.hpp"

namespace plica {

ElementTangent<24> state_tangent(const Model& model, const ShellQuad& quad);
ElementTangent<18> state_tangent(const Model& model, const ShellTriangle& triangle);
ElementTangent<12> state_tangent(const Model& model, const BeamElement& beam);
ElementTangent<Eigen::Dynamic> state_tangent(const Model& model, const BushingElement& bushing);
ElementTangent<6> state_tangent(const Model& model, const PressedEnd& end);

// Motion of a spring along its axes, m and rad, and its derivative by the DOFs of its nodes (6 x
// 12, to the ground 6 x 6).
struct SpringMotion {
  Eigen::Matrix<double, 6, 1> value;
  Eigen::Matrix<double, 6, Eigen::Dynamic> by_nodes;
};
SpringMotion state_motion(const Model& model, const BushingElement& bushing);

// Of the axis of a beam since rest, heat included.
double axial_strain(const Model& model, const BeamElement& beam);

// Stress at the corners of a shell on both faces, and of the fibres of a beam, at the state: as
// shell_mitc4_face_stress and beam_end_stress.
Eigen::VectorXd state_stress(const Model& model, const ShellQuad& quad);
Eigen::VectorXd state_stress(const Model& model, const ShellTriangle& triangle);
Eigen::VectorXd state_stress(const Model& model, const BeamElement& beam);

// Forces of all elements on their nodes at the state, over all DOFs (N, Nm): strain energy and
// pressure. Matrix elements are linear. The same whatever the number of threads.
Eigen::VectorXd state_forces(const Model& model);
// With these quads alone, `times` over.
Eigen::VectorXd state_forces(const Model& model, const std::vector<int>& quads, double times);

} // namespace plica

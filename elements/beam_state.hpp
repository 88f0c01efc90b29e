// The beam of elements/beam_timoshenko.hpp, and a bushing, at a state of finite displacement and
// rotation.
//
// Beam: strains between its two ends from their triads d1 (along the axis), d2, d3, in the middle
//   gamma_k = d_k . x' - delta_k1,   kappa_1 = (d3 . d2' - d2 . d3') / 2 and in turn
// (Reissner, Z. angew. Math. Phys. 32 (1981) 734-744; Simo, Comput. Methods Appl. Mech. Eng. 49
// (1985) 55-70), with the shear stiffness 1/(1/GA + L^2/(12 EI)), which makes it the exact element
// at rest (MacNeal 1978). Energy per length:
//   EA e^2/2 + GA* gamma^2/2 + GJ kappa_1^2/2 + EI kappa^2/2
//   e = gamma_1 + c gamma^2/2 + L^2 kappa^2/6 + rho^2 kappa_1^2/2 - thermal strain
// What stands beside gamma_1 in e is the length that the deflection within the element takes up
// (its cubic shape; c = 1 + 0.2/(1 + phi)^2), and its twist (rho^2 = (EI_y + EI_z)/EA); with it an
// axial force acts between the nodes as well as on them.
//
// Bushing: displacement and rotation of node 2 against node 1 in axes that turn with node 1, at the
// point that its law acts at; node 1 may be the ground, moved.
#pragma once

#include "elements/beam_timoshenko.hpp"
#include "elements/bushing.hpp"
#include "elements/element_state.hpp"

namespace plica {

// `rest`: as drawn, offsets and up at rest. `node1`, `node2`: places now.
ElementTangent<12> beam_tangent(const BeamGeometry& rest, const BeamProperties& section,
                                const Eigen::Vector3d& node1, const Eigen::Vector3d& node2,
                                const NodeRotations<2>& turned,
                                StiffnessPart part = StiffnessPart::all);

// e above, what is thermal left in.
double beam_axial_strain(const BeamGeometry& rest, const BeamProperties& section,
                         const Eigen::Vector3d& node1, const Eigen::Vector3d& node2,
                         const NodeRotations<2>& turned);

// Axial stress of the fibres at node 1, then at node 2, as beam_end_stress. Pa.
Eigen::VectorXd beam_state_stress(const BeamGeometry& rest, const BeamProperties& section,
                                  const Eigen::Vector3d& node1, const Eigen::Vector3d& node2,
                                  const NodeRotations<2>& turned);

// A node, or a place of the ground: at rest, now, and its rotation since.
struct MovedNode {
  Eigen::Vector3d rest{0, 0, 0}, now{0, 0, 0};
  Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
};

// Motion of node 2 against node 1 in the axes of a bushing, and its derivative by increments of
// their DOFs.
struct BushingMotion {
  Eigen::Matrix<double, 6, 1> value;
  Eigen::Matrix<double, 6, 12> by_nodes;
};
BushingMotion bushing_motion(const Bushing& bushing, const MovedNode& node1, const MovedNode& node2,
                             const Eigen::Vector3d& point);

// The law acts at `point` of the shape at rest.
ElementTangent<12> bushing_tangent(const Bushing& bushing, const MovedNode& node1,
                                   const MovedNode& node2, const Eigen::Vector3d& point,
                                   StiffnessPart part = StiffnessPart::all);

} // namespace plica

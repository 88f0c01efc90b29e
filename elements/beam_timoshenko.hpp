// Straight two-node Timoshenko beam in space.
//
// Exact under end loads: phi = 12 EI / (GA L^2) in the static shape functions (Przemieniecki,
// Theory of Matrix Structural Analysis, 1968, sec. 5.6); phi = 0 when shear-rigid. Mass: consistent
// with the same shape functions, rotary and polar inertia included (Friedman & Kosmatka, Comput.
// Struct. 47 (1993) 473-481). DOF order per node: ux uy uz rx ry rz in global axes. Rigid arms lead
// from a node to the end of the beam axis.
#pragma once

#include "elements/beam_section.hpp"

#include <Eigen/Core>

namespace plica {

using Matrix12 = Eigen::Matrix<double, 12, 12>;

struct BeamGeometry {
  Eigen::Vector3d node1, node2;                       // m
  Eigen::Vector3d up{0, 0, 1};                        // local z lies in the plane of axis and up
  Eigen::Vector3d offset1{0, 0, 0}, offset2{0, 0, 0}; // node to end of the axis, m, global axes
};

// Both throw std::invalid_argument when the axis has no length or is parallel to `up`.
Matrix12 beam_stiffness(const BeamGeometry& geometry, const BeamProperties& section);
Matrix12 beam_mass(const BeamGeometry& geometry, const BeamProperties& section);

// Axial stress of the fibres of the section at node 1, then at node 2, from the nodal
// displacements: 2 x fibres rows, Pa. From the end forces K u: exact where no load acts in between.
Eigen::Matrix<double, Eigen::Dynamic, 12> beam_end_stress(const BeamGeometry& geometry,
                                                          const BeamProperties& section);

} // namespace plica

// A beam whose section twists about another line than that along which it is stretched and weighs.
//
// v, w and twist are those of the shear centre, u that of the neutral axis: with r from the shear
// centre to the centroid and x along the beam, u = u_s + x . (theta x r) in the stiffness of the
// plain beam, and the whole rigid arm u_s + theta x r in its mass. Exact for the stiffness, of
// second order in the length of the element for the mass.
#pragma once

#include "solve/model.hpp"

namespace plica {

// Arms from the line of shear centres, global axes, m.
struct Eccentricity {
  Eigen::Vector3d neutral = Eigen::Vector3d::Zero(); // of stretch, bending and mass of the section
  Eigen::Vector3d extra = Eigen::Vector3d::Zero();   // of what weighs and does not bear
  double extra_mass = 0, extra_inertia = 0;          // of that, per length; about the beam's axis

  bool is_none() const { return neutral.isZero(0) && (extra_mass == 0 || extra.isZero(0)); }
};

// 12 x 12 of the line of shear centres, global axes; the section without what is extra.
struct BeamMatrices {
  Eigen::MatrixXd K, M;
};
BeamMatrices eccentric_beam(const BeamGeometry& ends, const BeamProperties& section,
                            const Eccentricity& eccentricity);

} // namespace plica

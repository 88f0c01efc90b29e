#include "run/analyses/static_stiffness.hpp"

#include "solve/statics.hpp"

namespace plica {

StaticStiffness static_stiffness(const Matrix1212& K, bool at_state) {
  const EndStiffness k = end_stiffness(K.bottomRightCorner<6, 6>(), at_state);
  return {.k_axial = k.axial,
          .k_transverse_x = k.transverse_x,
          .k_transverse_z = k.transverse_z,
          .k_bending_x = k.bending_x,
          .k_bending_z = k.bending_z,
          .k_torsion = k.torsion,
          .end_stiffness = K};
}

} // namespace plica

// What a rig feels of the damping of a state beside that of its modes: loss factors of components
// and dampers between nodes, over the coordinates of the reduced model.
//
//   L(omega) = sum_k loss_k(omega) dK_k,   dK_k: the stiffness of a component, or of a unit spring
//   in place of a damper
//
// Each is a change of the model like any other, so that it is there whatever else changes. What an
// effect adds has no loss of its own; walls that are solved by matrices have none here.
#pragma once

#include "model/shape/build.hpp"
#include "reduction/parametric_model.hpp"

namespace plica {

struct RigLoss {
  PreparedChange stiffness;
  std::function<double(double omega)> loss; // imaginary part over that stiffness
};

// Without what the mounts lose, which a rig has not.
std::vector<RigLoss> rig_losses(const Damping& damping, const BuiltCase& built,
                                const ParametricModel& model);

} // namespace plica

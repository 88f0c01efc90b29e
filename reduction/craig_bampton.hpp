// Craig-Bampton reduction of any model, and of one with rotational symmetry.
#pragma once

#include "reduction/cyclic_model.hpp"
#include "reduction/superelement.hpp"

namespace plica {

// Boundary: nodes with all six DOFs free of constraints. Modes with the boundary held up to
// `cutoff` (Hz) are kept and proved complete. Constraint modes from one factorisation. Throws
// std::invalid_argument naming the node when one is given twice or is the dependent side of a
// coupling, and std::runtime_error when the part is a mechanism with its boundary held.
Reduction craig_bampton(const Model& model, const std::vector<int>& boundary, double cutoff);

// The same by rotational symmetry. Boundary nodes on the axis are reached by the harmonics 0 and 1
// alone; the others, whose modes no boundary node feels, are left out unless `all_harmonics` asks
// for them. Nodes on the wall (a sensor with mass, a bracket, the ring at which a dented stretch
// begins) are reached by all N/2 + 1 harmonics, and all are taken, so that statics stay those of
// the full mesh. Holding a wall node would break the symmetry; the modes are therefore those with
// the axis nodes held and the wall nodes free, and with the answers X to unit forces at the wall
// nodes they span the coordinates (Craig & Chang, NASA CR-145204 (1976)):
//
//   F = X_p,  Psi_p = X F^-1,  Psi = Psi_axis - Psi_p (Psi_axis)_p,  Phi = Phi_free - Psi_p (Phi)_p
Reduction craig_bampton(const CyclicModel& model, const std::vector<int>& boundary, double cutoff,
                        bool all_harmonics = false);

} // namespace plica

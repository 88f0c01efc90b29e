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

// The same by rotational symmetry; boundary nodes lie on the axis. Harmonics above 1 do not reach
// them and are left out.
Reduction craig_bampton(const CyclicModel& model, const std::vector<int>& boundary, double cutoff);

} // namespace plica

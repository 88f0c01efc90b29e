// From a Case to a model that can be solved: meshes, sections, couplings, masses, supports.
#pragma once

#include "model/shape/built_case.hpp"

namespace plica {

// Throws InputError (key paths, no file or line) for what only the mesh can tell: a sensor off the
// part, a set that is not there, constraints that contradict each other.
// Stuck, the model bears the stiffness that its joints have in small motion.
BuiltCase build(const Case& data);

// Slipping, it bears what is left beside their friction. `plies`: of every bellows with `wall.slip`
// by its name, the laws of its plies from end to end; slipping_case() finds them, too. Throws
// std::out_of_range where one is missing.
BuiltCase build_slipping(const Case& data, const PlyLaws& plies);

} // namespace plica

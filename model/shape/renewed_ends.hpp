// A built case whose caps are given other masses and whose mounts other springs, without meshing
// anew.
#pragma once

#include "model/shape/built_case.hpp"

namespace plica {

// Whether a path of the case file is mass, inertia or offset of a cap, or springs of a mount: what
// lies on the reference nodes of caps alone. The springs of a cap do not: they lead to a node of
// the part.
bool is_of_ends(const std::string& path);

// `built`, made from `before`, with the caps and mounts of `after`, where both differ at such
// paths alone. False, and nothing that could be used, where a cap or mount is of another kind
// (held, free, on springs) or what was to be changed is not there. Neither may have friction or
// dampers at its ends.
bool renew_ends(BuiltCase& built, const Case& before, const Case& after);

} // namespace plica

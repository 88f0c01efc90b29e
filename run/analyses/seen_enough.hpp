// Whether a run needs the fields of all nodes.
#pragma once

#include "model/description/case.hpp"
#include "run/routes/seen_case.hpp"

namespace plica {

// Whether the shapes of all nodes are recovered and kept in the results.
enum class Shapes {
  kept,
  left_out // where superelements allow it and nothing that is asked for needs them
};

// The case at the nodes that its numbers are read from. None where it is not solved by
// superelements, where it asks for more than modes, statics and responses of sensors to its base
// and to forces (a state, friction, levels, life, stress, coupled losses, motions of ends, a direct
// solution), and where seen_case() has none.
std::optional<SeenCase> seen_enough(const Case& data, const BuiltCase& built);

} // namespace plica

// Dynamic stiffness between two ends as springs and dashpots over frequency, for programs that have
// no complex matrices: the connector in the middle between the ends (connector_in_middle()), its
// six terms on the diagonal. The inertia of the part is left away; what lies off the diagonal, too.
// One property per state and level; SI, or mm, t, s, N.
#pragma once

#include "reduction/dynamic_stiffness.hpp"

namespace plica {

// Of the largest term off the diagonal of any frequency, over the root of both on it: what the
// tables leave away.
double left_off_diagonal(const StateStiffness& state);

// Nodes 1 and 2 at the ends, 3 and 4 in the middle, led by them; one connector element, and a
// *CONNECTOR BEHAVIOR with elasticity and viscous damping over frequency for every state and level.
// For steady-state dynamics, direct.
std::string abaqus_connector(const EndDynamicStiffness& s, bool millimetres);

// The same as CBUSH with PBUSH, PBUSHT and TABLED1 (stiffness K, force per velocity B). For direct
// or modal frequency response.
std::string nastran_bush(const EndDynamicStiffness& s, bool millimetres);

} // namespace plica

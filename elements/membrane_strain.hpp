// Membrane strain of a four-node shell (elements/shell_mitc4.hpp): of the displacements, assumed as
// in MITC4+, or with incompatible modes.
#pragma once

namespace plica {

enum class MembraneStrain { displacement, mitc4_plus, incompatible };

} // namespace plica

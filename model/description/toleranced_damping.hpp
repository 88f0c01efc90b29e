// The one number of the analyses that takes a tolerance: stiffness, mass and stress know nothing of
// it, a diagnosis scatters all damping by it.
#pragma once

namespace plica {

inline constexpr const char* toleranced_damping = "analyses.damping.modal"; // path in the case

} // namespace plica

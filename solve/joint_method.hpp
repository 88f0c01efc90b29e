// How the forces of joints in periodic motion are found.
#pragma once

namespace plica {

// All harmonics by alternating frequency and time, or the first alone by equivalent linearisation.
enum class JointMethod { harmonic_balance, describing_function };

} // namespace plica

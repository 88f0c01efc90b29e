// Names of the stages of a run: who begins one and who shows how far a run is take them from here.
#pragma once

namespace plica::stages {

inline constexpr const char *mesh = "mesh", *state = "state", *symmetry = "symmetry",
                            *reduction = "reduction", *assembly = "assembly",
                            *factorisation = "factorisation", *statics = "statics",
                            *modes = "modes", *recovery = "recovery", *labels = "labels",
                            *complex_modes = "complex modes", *response = "response",
                            *direct_solution = "direct solution",
                            *dynamics = "transients and run-ups", *stress = "stress",
                            *joints = "reduced model of the joints", *life = "life";
// How far the state is follows the first, what is excited the second, a path in the case the third.
inline constexpr const char *state_at = "state, ", *levels_of = "levels of ",
                            *tolerance_of = "tolerance of ";
inline constexpr const char *finer_along = "finer along", *finer_around = "finer around";

} // namespace plica::stages

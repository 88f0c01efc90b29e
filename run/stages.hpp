// Stages of a run: who begins one and who shows how far a run is take their kinds from here.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace plica {

// What a run does next. It is said as its kind with the words behind it: "levels of y".
struct Stage {
  Stage(const char* of_kind, std::string behind = "", double share = 0)
      : kind(of_kind), words(std::move(behind)), done(share) {}
  operator std::string() const { return std::string(kind) + words; }

  std::string_view kind;
  std::string words;
  double done; // share of the stage that lies behind, where it is told more than once
};

using StageListener = std::function<void(const Stage&)>;

namespace stages {

inline constexpr const char *mesh = "mesh", *state = "state", *symmetry = "symmetry",
                            *reduction = "reduction", *assembly = "assembly",
                            *factorisation = "factorisation", *statics = "statics",
                            *modes = "modes", *recovery = "recovery", *labels = "labels",
                            *complex_modes = "complex modes", *response = "response",
                            *direct_solution = "direct solution",
                            *dynamics = "transients and run-ups", *stress = "stress",
                            *joints = "reduced model of the joints", *life = "life";
// What is excited follows the first, a path in the case the second.
inline constexpr const char *levels_of = "levels of ", *tolerance_of = "tolerance of ";
inline constexpr const char *finer_along = "finer along", *finer_around = "finer around";
// Parts of other stages and of other commands.
inline constexpr const char *buckling = "buckling", *tolerances = "tolerances",
                            *tolerances_together = "tolerances together", *cut_off = "cut-off",
                            *certificate = "certificate";

} // namespace stages

} // namespace plica

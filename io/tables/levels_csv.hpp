// Tables of responses at several levels (csv.hpp says how they are written).
#pragma once

#include "run/results/results.hpp"

#include <string>

namespace plica {

std::string levels_name(const LevelResponses& responses);  // "levels_y", "levels_force_push"
std::string levels_title(const LevelResponses& responses); // "Base moved in y"

std::string levels_csv(const LevelResponses& responses); // every point of every branch
std::string level_peaks_csv(const Results& results);     // peaks of slow sweeps up and down
std::string level_joints_csv(const Results& results);    // motion and energy of every joint
std::string level_backbones_csv(const Results& results); // frequency and damping over amplitude

} // namespace plica

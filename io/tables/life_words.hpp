// Fatigue life and stress by place in words, as the terminal, the files and the report have them.
#pragma once

#include "run/results/results.hpp"

#include <string>
#include <vector>

namespace plica {

// "bellows root 1, inner face", "web, face above"; of a ply "..., ply 2".
std::string place_words(const StressPlace& place, bool outer, int ply = 0);

// The row of a table with the largest von Mises stress; null without rows.
const PlaceStress* hottest(const StressTable& table);

// "at most 0.0021", "0.266": damages and counts with what bounds them.
std::string bounded(const std::string& number, bool at_most, bool at_least);
std::string life_words(const CurveLife& life); // "5 258", "at least 1 000 000", "unlimited"
// "0.0012 to 0.0047"
std::string damage_words(const std::array<double, 2>& between);
// "3 120 to 9 870", of a duty of many ranges "damage 0.0012 to 0.0047"; "-" without an interval.
std::string between_words(const DutyResult& duty);

// Whether the lives are those of a design curve, have a scatter or are as their curve has them, and
// of what the intervals are.
std::string life_kind(const LifeResult& life);

// How often all duties together come to damage 1 at the first spot; empty without damage.
std::string repeats_words(const LifeResult& life);

// What the mesh still misses of the range of a duty, in percent; "-" where it is not known.
std::string duty_mesh_error(const Results& results, const DutyResult& duty);

// Likewise of the von Mises stress of a row of a stress table.
std::string place_mesh_error(const Results& results, std::size_t table, std::size_t row);

// For the terminal; empty without a life.
std::string life_summary(const Results& results);
std::string stress_summary(const Results& results);

} // namespace plica

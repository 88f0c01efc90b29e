// A diagnosis in words.
#pragma once

#include "diagnose/results/diagnosis.hpp"

namespace plica {

// "none", "identified", "ambiguous", "pair", "unknown"
std::string verdict_name(Verdict verdict);

// "added_mass at beam.point[3] (all round)"; of a hypothesis joined by "and", "none" = nominal.
std::string effect_label(const NamedEffect& effect);
std::string hypothesis_label(const TriedHypothesis& hypothesis);

// What the gap is closed with (Diagnosis::best); null for the nominal case.
const TriedHypothesis* best_hypothesis(const Diagnosis& d);

// Blocks of readings without the components, and components alone; each with the farthest first.
std::vector<LocatedGap> located_blocks(const Diagnosis& d);
std::vector<LocatedGap> located_components(const Diagnosis& d);

// For the terminal.
std::string diagnosis_text(const Diagnosis& d);

} // namespace plica

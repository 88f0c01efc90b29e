// A diagnosis in words.
#pragma once

#include "diagnose/results/diagnosis.hpp"
#include "io/tables/text.hpp"

namespace plica {

// "none", "identified", "ambiguous", "several", "mostly", "unknown"
std::string verdict_name(Verdict verdict);

// "added_mass at beam.point[3] (all round)"; of a hypothesis joined by "and", "none" = nominal.
std::string effect_label(const NamedEffect& effect);
std::string hypothesis_label(const TriedHypothesis& hypothesis);

// "20 g that nobody weighed" (Effect::plain), without its place.
std::string plain_words(const NamedEffect& effect);
// A row of the ledger: "20 g that nobody weighed, at sensor mid"; a list by its names; what is
// left: "not explained", "what measuring leaves open".
std::string row_words(const LedgerRow& row);
// More effects in one row than are read at a glance: its words name the first alone.
bool is_long(const LedgerRow& row);

// Readings in which what no effect explains sits, where it is worth a word.
std::vector<std::pair<std::string, double>> most_left_in(const Ledger& ledger);
// For the terminal.
std::string ledger_text(const Ledger& ledger);

// As shown_unit(), and small lengths and masses in mm, µm, g, angles in degrees.
ShownUnit handy_unit(double value, const std::string& unit);

// What the gap is closed with (Diagnosis::best); null for the nominal case.
const TriedHypothesis* best_hypothesis(const Diagnosis& d);

// Blocks of readings without the components, and components alone; each with the farthest first.
std::vector<LocatedGap> located_blocks(const Diagnosis& d);
std::vector<LocatedGap> located_components(const Diagnosis& d);

// For the terminal.
std::string diagnosis_text(const Diagnosis& d);

} // namespace plica

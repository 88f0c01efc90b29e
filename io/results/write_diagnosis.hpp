// What `plica diagnose` leaves behind: diagnosis.json, diagnosis_readings.csv,
// diagnosis_hypotheses.csv, diagnosis_where.csv, diagnosis.html. SI units, Hz.
#pragma once

#include "diagnose/diagnosis.hpp"
#include "io/output/output_folder.hpp"

namespace plica {

std::vector<std::string> diagnosis_files();
void write_diagnosis(const Diagnosis& d, const std::string& title, const std::string& plica_version,
                     OutputFolder& out);

// The same in words, for the terminal.
std::string diagnosis_text(const Diagnosis& d);
std::string diagnosis_json(const Diagnosis& d, const std::string& plica_version);

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

} // namespace plica

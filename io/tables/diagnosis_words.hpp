// A diagnosis in words.
#pragma once

#include "diagnose/results/diagnosis.hpp"

namespace plica {

// "none", "identified", "ambiguous", "several", "mostly", "unknown"
std::string verdict_name(Verdict verdict);

// What the gap is closed with (Diagnosis::best); null for the nominal case.
const TriedHypothesis* best_hypothesis(const Diagnosis& d);

// For the terminal: the first screen, behind a blank line the evidence in tables.
std::string diagnosis_text(const Diagnosis& d);

} // namespace plica

// What was found, as the user is told: effects with their intervals, where the gap lies, how far it
// shrinks, what else would close it, what to measure next.
#pragma once

#include "diagnose/account/findings.hpp"
#include "diagnose/results/settings.hpp"

namespace plica {

// Tells the stage of what takes time.
Diagnosis account_of(GapProblem& problem, const Findings& found, const DiagnosisSettings& settings);

} // namespace plica

// Diagnosis of the gap between a case and its test (docs/diagnosis.md).
#pragma once

#include "diagnose/results/diagnosis.hpp"
#include "diagnose/readings/readings.hpp"
#include "model/description/case.hpp"

#include <functional>
#include <set>

namespace plica {

struct DiagnosisSettings {
  // Guards left out, for ablations: form, nuisance, reassembly, adequacy, levels (all but the
  // lowest), heldout.
  std::set<std::string> without = {};
  bool plan_next = true; // propose the next measurement
  int particles = 160;   // of the Markov chains
  std::function<void(const std::string&)> stage = [](const std::string&) {};
};

// Throws InputError as build() does; std::invalid_argument when the test has nothing that the model
// answers.
Diagnosis diagnose(const Case& data, const DiagnosisData& test, const DiagnosisSettings& settings);

} // namespace plica

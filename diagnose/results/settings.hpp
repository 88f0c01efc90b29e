// What a diagnosis is asked for.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace plica {

struct DiagnosisSettings {
  // Guards left out, for ablations: form, nuisance, reassembly, adequacy, levels (all but the
  // lowest), heldout.
  std::set<std::string> without = {};
  bool plan_next = true;               // propose the next measurement
  int particles = 160;                 // of the Markov chains
  std::vector<std::string> words = {}; // what was done to the case before, told among assumptions
  std::function<void(const std::string&)> stage = [](const std::string&) {};
};

} // namespace plica

// What a diagnosis is asked for.
#pragma once

#include <array>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace plica {

// What keeps a diagnosis from being sure and wrong; levels: all but the lowest.
enum class Guard { form, nuisance, reassembly, adequacy, levels, heldout };
inline constexpr std::array guard_names{"form",     "nuisance", "reassembly",
                                        "adequacy", "levels",   "heldout"};
using Guards = std::set<Guard>;

struct DiagnosisSettings {
  Guards without = {};                 // guards left out, for ablations
  bool plan_next = true;               // propose the next measurement
  int particles = 160;                 // of the Markov chains
  std::vector<std::string> words = {}; // what was done to the case before, told among assumptions
  // Called before each stage, with the share of the work that lies before it, as far as it is known
  // (0 = it is not).
  std::function<void(const std::string& name, double share)> stage = [](const std::string&,
                                                                        double) {};
  // Called as a stage goes on, with the share that lies behind, from one thread at a time.
  std::function<void(double share)> advance = [](double) {};
  // The search for effects begins; from here on `stop` ends it: what was found so far is told, and
  // that it is no more than that.
  std::function<void()> search = [] {};
  std::function<bool()> stop = [] { return false; };
};

} // namespace plica

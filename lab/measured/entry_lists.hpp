// The lists of measured.yaml whose entries were measured in a state of the specimen.
#pragma once

#include "lab/measured/measured.hpp"

#include <set>
#include <string>

namespace plica {

// `act` on each list with its key, "modes". Weighings are none of them: one stands as "mass" alone.
template <class MeasuredOrConst, class Act>
void for_each_list(MeasuredOrConst& measured, const Act& act) {
  act(measured.statics, "static");
  act(measured.stiffness, "stiffness");
  act(measured.modes, "modes");
  act(measured.peaks, "peaks");
  act(measured.frf, "frf");
  act(measured.signals, "signals");
}

// Names of the states in which something was measured, "" = as it stands.
inline std::set<std::string> states_in_use(const Measured& measured) {
  std::set<std::string> used;
  for (const MeasuredMass& w : measured.weighings) used.insert(w.state);
  for_each_list(measured, [&](const auto& entries, const char*) {
    for (const auto& entry : entries) used.insert(entry.state);
  });
  return used;
}

} // namespace plica

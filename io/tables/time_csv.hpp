// Tables of transients and run-ups (csv.hpp says how they are written; signals over time have nine
// digits).
#pragma once

#include "run/results/results.hpp"

#include <string>

namespace plica {

std::string transient_csv(const TransientResult& transient); // input and channels over time
std::string shock_csv(const TransientResult& transient);     // shock spectra; needs `spectra`
std::string run_up_csv(const RunUpResult& run_up);           // orders and overall over the speed
std::string run_up_time_csv(const RunUpResult& run_up);      // over time; needs `sweeps`
std::string crossings_csv(const Results& results);           // of all run-ups

// What files are named after: "transient_pothole.csv", "shock_...", "run_up_...".
std::string transient_file(const std::string& name);
std::string shock_file(const std::string& name);
std::string run_up_file(const std::string& name);
std::string run_up_time_file(const std::string& name);

} // namespace plica

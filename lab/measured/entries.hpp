// Entries of the lists of measured.yaml by their paths, as hold_out and messages have them.
#pragma once

#include "lab/measured/measured.hpp"

#include <map>
#include <string>
#include <vector>

namespace plica {

std::string entry_name(const char* list, std::size_t i); // "frf[3]"
// "mass", as one weighing is written; of several "mass[1]".
std::string weighing_name(const Measured& measured, std::size_t i);

// By itself or with the entry that it is of: "peaks[0]" holds out "peaks[0].frequency[3]".
bool is_held_out(const Measured& measured, const std::string& entry);

// Paths as they read after their entries have other names, `now` by the old ones; a path whose
// entry has none is left out.
std::vector<std::string> renamed_paths(const std::vector<std::string>& paths,
                                       const std::map<std::string, std::string>& now);

} // namespace plica

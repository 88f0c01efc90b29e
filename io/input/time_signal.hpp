// The samples of the signals that a case names.
#pragma once

#include "model/description/case.hpp"

#include <filesystem>

namespace plica {

// Fills what transients and histories of the case act with from the files in a folder. Throws
// InputError, with the file or the key ("analyses.transients[0].signal.channel").
void read_signals(Case& data, const std::filesystem::path& folder);

// The file of a signal as the case names it, and the key under which the signal stands.
struct SignalFile {
  std::string file, key;
};
std::vector<SignalFile> signal_files(const Analyses& analyses);

} // namespace plica

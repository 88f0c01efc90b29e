// The samples of the signals that a case names.
#pragma once

#include "model/description/case.hpp"

#include <filesystem>

namespace plica {

// Fills what transients and histories of the case act with from the files in a folder. Throws
// InputError, with the file or the key ("analyses.transients[0].signal.channel").
void read_signals(Case& data, const std::filesystem::path& folder);

} // namespace plica

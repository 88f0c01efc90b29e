// What the terminal shows at the end of a run: plain text, aligned columns, one screen.
#pragma once

#include "run/results/results.hpp"

#include <filesystem>
#include <string>

namespace plica {

// `report` is named in the last line; empty: no such line.
std::string summary_text(const Results& results, const std::filesystem::path& report = {});

} // namespace plica

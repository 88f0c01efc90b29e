// The case that a folder stands for.
#pragma once

#include <filesystem>
#include <string>

namespace plica {

// A path that is no folder, as it is. Of a folder the file in it that has its name, or else the one
// case (or benchmark) in it, by its first key. Throws InputError for a folder without one and for
// several, which it names.
std::string case_file_of(const std::string& path);

} // namespace plica

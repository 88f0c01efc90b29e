// A superelement as a MATLAB file (version 5): K M and, with damping, C D; nodes (n x 3); cell
// arrays node_names and coordinates (the order of rows and columns); name, units; per sensor
// recovery and per load load vectors in structures.
#pragma once

#include "reduction/superelement.hpp"

#include <filesystem>

namespace plica {

// Both throw std::runtime_error with path and reason; nothing is left half-written.
void write_matlab(const Superelement& s, const std::filesystem::path& path);

// All but the names of loads and sensors' places: what the file is made for.
Superelement read_matlab(const std::filesystem::path& path);

} // namespace plica

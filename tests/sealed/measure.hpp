// Tests of one specimen and their files: measured.yaml with its tables, and the truth apart.
//
// Noise (standard deviations, stated in measured.yaml where it has a place for them): responses
// 1.5 % of the magnitude, at least 0.01, half of the variance in each part; stiffness 1.5 %; the
// scale 0.2 %; single frequencies 0.1 %, rounded to 0.01 %, and dampings 5 % beside the 0.2 % and
// 4 % of every assembly. Lines stand every 4 Hz, half a percent of the first frequency.
#pragma once

#include "response.hpp"

#include <filesystem>

namespace sealed {

// Makes the specimen and writes <data>/<id>/. Returns what of the truth only comes to light then.
std::map<std::string, double> measure(const Specimen& s, const ReducedWall* wall,
                                      std::uint64_t seed, const std::filesystem::path& data);

} // namespace sealed

// What modes are called by how a part moves in them.
#pragma once

#include <array>

namespace plica::mode_kind {

// As a rod on the axis: along, across, about it.
inline constexpr const char* axial = "axial";
inline constexpr const char* transverse = "transverse";
inline constexpr const char* torsion = "torsion";
inline constexpr std::array of_a_rod{axial, transverse, torsion};

inline constexpr const char* shell = "shell"; // the wall bends within its section
inline constexpr const char* rigid = "rigid"; // nothing is strained
inline constexpr const char* unnamed = "mode";

} // namespace plica::mode_kind

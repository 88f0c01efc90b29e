// modes.vtu: the mesh and its mode shapes for ParaView (VTK unstructured grid, zlib-compressed,
// appended raw binary).
//
// Cells: the quads, then the lines. Cell data: "thickness" (m, mean of the corners; 0 on lines) and
// "section". Point data: one vector of translations per mode, "mode 01: 116.2 Hz", mass-normalised
// as computed ("Warp By Vector" animates it).
#pragma once

#include "run/results/results.hpp"

#include <string>

namespace plica {

// The bytes of the file. Throws std::invalid_argument when a shape has not one row per node,
// std::runtime_error when VTK fails.
std::string modes_vtu(const Results& results);

// The same mesh with von Mises stress (Pa) on both faces of the shells, point data named
// "mode above: mode 1, 1 mm at most".
std::string stress_vtu(const Results& results);

} // namespace plica

// Dynamic stiffness in HDF5, for numpy and MATLAB:
//
//   /                  attributes format "plica dynamic stiffness", version 1, name, units
//   frequency          [frequencies], Hz
//   amplitude, angle   [levels], m and rad; 0 = small motion
//   states             [states] text; coordinates: [12] text; places: [2, 3], m
//   real, imaginary    [states, levels, frequencies, 12, 12], force on a coordinate (row) by the
//                      motion of one (column)
//   static             [states, 12, 12]: the condensation that both tend to at 0 Hz, joints
//   slipping
#pragma once

#include "reduction/dynamic_stiffness.hpp"

#include <filesystem>

namespace plica {

// Throws H5::Exception.
void write_stiffness_hdf5(const EndDynamicStiffness& s, const std::filesystem::path& path);

} // namespace plica

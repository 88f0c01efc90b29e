// Plica's own file of a superelement (HDF5): everything, without loss.
//
//   /              attributes format = "plica superelement", version = 2, name, units, dof_order
//   /node_names    text, one per boundary node          /nodes   n x 3, in `units`
//   /K /M          square, coordinates of superelement.hpp; /C /D where there is damping
//   /recovery/k    attribute name; place (3), rows (6 x coordinates)
//   /stresses/k    attribute name; place (3), rows (12 x coordinates: xx yy zz xy yz zx of the face
//                  below, then above)
//   /loads/k       attribute name; force (coordinates)
#pragma once

#include "reduction/superelement.hpp"

#include <filesystem>

namespace plica {

// Written beside the target first and renamed. Throws std::runtime_error with path and reason.
void write_hdf5(const Superelement& s, const std::filesystem::path& path);

} // namespace plica

// Modes of a universal file as a test: data sets 55 and 2414 (normal and complex modes,
// displacements, velocities or accelerations at nodes), places of the nodes from 15, 781 and 2411,
// axes of their displacements from 18 and 2420, units from 164.
#pragma once

#include "lab/measured/measured.hpp"

#include <filesystem>

namespace plica {

// By its name: .uff .unv .uf .ufb .bunv
bool is_universal_file(const std::filesystem::path& path);

// Sensors "node12" at their places (m), modes with vectors over their channels "node12.x" in the
// axes of the file, which are taken for those of the part frame. Kind and direction of each mode
// follow from its vector (kind_of()), orders from the lowest. Caveats say what else the file holds,
// and what it does not say. A set 82 draws lines and is passed over.
// Throws InputError: no modes, a node whose axes are not stated or are not straight, what the
// reader refuses.
Measured modes_of_universal(const std::filesystem::path& path);

} // namespace plica

// Everything that `plica stiffness` leaves behind.
#pragma once

#include "compare/compare_stiffness.hpp"
#include "io/files/output_folder.hpp"

namespace plica {

std::vector<std::string> stiffness_files(bool measured);

// InputError with path and reason.
void write_stiffness(const EndDynamicStiffness& s, const std::vector<StiffnessComparison>& compared,
                     bool millimetres, OutputFolder& out);

} // namespace plica

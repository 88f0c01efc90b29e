// Measured dynamic stiffness from a table of numbers (csv_table.hpp): a column "frequency [Hz]",
// one "amplitude" (m, mm, um, rad, deg) where there are several, and columns named by direction,
// kind and quantity, "y storage [N/mm]", "y loss [N/mm]", "rx driving point magnitude [Nm/rad]", "x
// loss angle [deg]". Without "driving point" it is the blocked transfer stiffness.
#pragma once

#include "lab/measured/measured_stiffness.hpp"

#include <filesystem>

namespace plica {

// Throws InputError with file and line: no frequency, a name that is none of these, a unit that
// does not belong to its quantity, frequencies below zero.
std::vector<MeasuredStiffness> read_stiffness_table(const std::filesystem::path& path);

} // namespace plica

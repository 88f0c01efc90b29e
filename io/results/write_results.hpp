// Everything a run leaves behind: results.json, simulated.yaml (the run in the form of measured
// data), responses.uff, modes.csv, static.csv, comparison.csv, variants.csv, modes.vtu,
// report.html, and one or more files for each response and for stresses.
#pragma once

#include "model/results.hpp"

#include <filesystem>

namespace plica {

// Makes the folder when it is not there. All files are written under temporary names first and
// renamed at the end, results.json last: a run that fails or is stopped leaves the old files as
// they were, and a results.json always stands beside the files of the same run. Files of an older
// run that this one does not write are removed. InputError with the path and the reason when
// something cannot be written.
void write_results(const Results& results, const std::filesystem::path& out_dir);

} // namespace plica

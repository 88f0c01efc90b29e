// Everything a run leaves behind: results.json, simulated.yaml (the run in the form of measured
// data), responses.uff, modes.csv, static.csv, comparison.csv, variants.csv, modes.vtu,
// report.html, and one or more files for each response and for stresses.
#pragma once

#include "io/files/output_folder.hpp"
#include "model/description/case.hpp"
#include "run/results/results.hpp"

namespace plica {

// Names of what a run of the case will write, as far as the case tells.
std::vector<std::string> result_files(const Case& data);

// results.json comes last: once it is there, so are the other files of the same run. InputError
// with the path and the reason when something cannot be written.
void write_results(const Results& results, OutputFolder& out);

} // namespace plica

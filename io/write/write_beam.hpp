// What `plica reduce --beam` adds: the equivalent pipe and the chain of connectors as `models` for
// the case file (beam.yaml), what they cost (beam.csv: transfer stiffness over frequency), a table.
#pragma once

#include "io/files/output_folder.hpp"
#include "run/study/equivalent_beam.hpp"

namespace plica {

std::vector<std::string> beam_files();
void write_beam(const EquivalentBeam& beam, OutputFolder& out);

std::string beam_text(const EquivalentBeam& beam);
std::string beam_yaml(const EquivalentBeam& beam);

} // namespace plica

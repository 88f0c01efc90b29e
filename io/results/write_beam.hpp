// What `plica reduce --beam` adds: the equivalent pipe and the chain of connectors as `models` for
// the case file (beam.yaml), what they cost (beam.csv: transfer stiffness over frequency), a table.
#pragma once

#include "model/equivalent_beam.hpp"

#include <filesystem>

namespace plica {

void write_beam(const EquivalentBeam& beam, const std::filesystem::path& folder);

std::string beam_text(const EquivalentBeam& beam);
std::string beam_yaml(const EquivalentBeam& beam);

} // namespace plica

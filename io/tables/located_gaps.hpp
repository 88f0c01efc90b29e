// Where a gap lies, the farthest first.
#pragma once

#include "diagnose/results/diagnosis.hpp"

namespace plica {

// Blocks of readings without the components, and components alone; each with the farthest first.
std::vector<LocatedGap> located_blocks(const Diagnosis& d);
std::vector<LocatedGap> located_components(const Diagnosis& d);

} // namespace plica

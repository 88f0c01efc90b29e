// A case over all ranks, from its file to its results.
#pragma once

#include "engine/engine_options.hpp"
#include "engine/ranks.hpp"

namespace plica {

// Exit code as of `plica run`, the same on every rank. The first rank reads, runs and writes; the
// others read the case and mesh too, and compute what they are told.
int run_over_ranks(const EngineOptions& options, const Ranks& ranks);

} // namespace plica

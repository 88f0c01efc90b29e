// Ctrl-C and SIGTERM: work stops at the next stage, files of geometry that are being meshed at
// once, and what was finished is kept. A second one kills.
#pragma once

#include "mesh/generation/worker.hpp"

namespace plica {

void watch_interrupts(); // unless the shell has them ignored
bool is_interrupted();
void forget_interrupt(); // what was finished is being written

// From here on the first signal ends a search, which keeps the best it has, and the next one the
// program; until watch_interrupts().
void let_searches_end();
bool search_is_ended();

std::string interrupted_by(); // "Ctrl-C" or "SIGTERM"
int interrupted_exit();       // as a shell says it: 128 + the signal, 130 or 143

} // namespace plica

// Ctrl-C: work stops at the next stage, and what was finished is kept. A second one kills.
#pragma once

#include <string>

namespace plica {

// Thrown by Progress::stage after a Ctrl-C. Not a std::exception: nothing on the way mistakes it
// for a failure.
struct Interrupted {
  std::string stage; // that was not begun
};

void watch_interrupts(); // unless the shell has them ignored
bool is_interrupted();
void forget_interrupt(); // what was finished is being written

constexpr int interrupted_exit = 130; // as a shell says it: 128 + SIGINT

} // namespace plica

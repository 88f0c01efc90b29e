// Work on files of others in a process of its own: what crashes, runs for ever or eats all memory
// there is an error here, and Ctrl-C or SIGTERM ends it at once.
#pragma once

#include <string>
#include <vector>

namespace plica {

// Thrown where work was stopped by Ctrl-C or SIGTERM. Not a std::exception: nothing on the way
// mistakes it for a failure.
struct Interrupted {
  std::string stage; // that was not begun, or not finished
};

struct WorkerLimits {
  double seconds = 300; // by the clock
  double bytes = 0;     // of address space; 0 = three quarters of the memory of the machine
};

// From PLICA_MESH_SECONDS and PLICA_MESH_MEMORY (GB) where they are set. Throws std::runtime_error
// where these are no numbers above 0.
WorkerLimits worker_limits();

// Runs the program with `seconds bytes` and then these words, and gives back what it wrote on its
// descriptor 3; standard input and output are closed to it. Throws std::runtime_error, `subject`
// first, where it crashed or ran out of time, Interrupted{subject} where it was stopped. One at a
// time: other threads wait.
std::string run_worker(const std::string& program, const std::vector<std::string>& words,
                       const WorkerLimits& limits, const std::string& subject);

// Ends the worker that runs, and every later one, until allow_workers(). May be called from a
// signal handler.
void stop_workers() noexcept;
void allow_workers() noexcept;

// In the worker: takes the limits on, ends with its parent, and leaves Ctrl-C to it.
void become_worker(const WorkerLimits& limits);

} // namespace plica

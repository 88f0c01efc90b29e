// What `plica-mpi` is asked for.
#pragma once

#include "app/command_line.hpp"

#include <optional>

namespace plica {

struct EngineOptions {
  ChosenCase chosen;
  Output out;
  int threads = 1;    // of each rank
  int workspace = 30; // of MUMPS: percent beyond its estimate
  int megabytes = 0;  // of MUMPS: most for a rank; 0 = what it needs
};

// The exit code where there is nothing to run: help, version, or words that are wrong. `speaks`:
// this rank says so.
std::optional<int> parse(EngineOptions& options, int argc, char** argv, bool speaks);

} // namespace plica

// What `plica run` is asked for.
#pragma once

#include "app/command_line.hpp"

namespace plica {

struct RunOptions {
  ChosenCase chosen;
  Output out;
  int threads = 0;                   // 0 = all cores
  std::vector<std::string> geometry; // formats to write the part in, of geometry_formats()
  std::string deck;                  // abaqus or nastran: the model for another solver
  bool variants = true;
  bool error_bars = true;
};

// The run of a file with a `benchmark` key.
int run_benchmark(const RunOptions& options);

} // namespace plica

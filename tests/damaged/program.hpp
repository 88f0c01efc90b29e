// Runs of the program as a user runs it, each in a process of its own with limits on its time and
// memory.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plica::test {

struct Ended {
  int exit = -1;      // its exit code, -1 when a signal ended it
  std::string output; // of both streams
  std::string how;    // "exit 1", "signal 11", "no end within 30 s"
};

// `plica` with these arguments in that folder: its main() in a fork, which saves loading the
// libraries.
Ended run_plica(const std::vector<std::string>& arguments, const std::filesystem::path& folder);

} // namespace plica::test

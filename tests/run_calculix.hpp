// What CalculiX prints of a deck.
#pragma once

#include "io/files/files.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cstdlib>
#include <string>

namespace plica::test {

// The text of its model.dat; empty where CalculiX is not installed or breaks off.
inline std::string calculix_output(const std::string& deck) {
  const TemporaryFolder folder("calculix");
  write_whole(folder.path / "model.inp", deck);
  const std::string command =
      "cd '" + folder.path.string() + "' && OMP_NUM_THREADS=2 ccx -i model >log 2>&1";
  if (std::system(command.c_str()) != 0) return "";
  return read_whole(folder.path / "model.dat");
}

} // namespace plica::test

// What CalculiX finds for the deck of a whole, unreduced model.
#pragma once

#include "io/decks/abaqus.hpp"
#include "io/files/files.hpp"
#include "model/shape/build.hpp"

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

namespace plica::test {

// Eigenfrequencies in Hz; empty where CalculiX is not installed, or breaks off.
inline std::vector<double> calculix_frequencies(const Case& data,
                                                const std::filesystem::path& folder) {
  write_whole(folder / "model.inp", abaqus_model(data, build(data)));
  const std::string command = "cd '" + folder.string() + "' && OMP_NUM_THREADS=2 ccx -i model >log";
  if (std::system(command.c_str()) != 0) return {};
  std::istringstream stream(read_whole(folder / "model.dat"));
  std::vector<double> hertz;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream fields(line);
    double mode = 0, lambda = 0, omega = 0, f = 0, imaginary = 0;
    if (line.find("P A R T I C I P") != std::string::npos) break;
    if (fields >> mode >> lambda >> omega >> f >> imaginary) hertz.push_back(f);
  }
  return hertz;
}

} // namespace plica::test

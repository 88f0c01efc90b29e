// Displacements that CalculiX prints of a deck.
#pragma once

#include "io/files/files.hpp"
#include "tests/support/temporary_folder.hpp"

#include <Eigen/Core>

#include <cstdlib>
#include <map>
#include <sstream>
#include <vector>

namespace plica::test {

// Of the nodes that *NODE PRINT names, step by step; empty where CalculiX is not there.
inline std::vector<std::map<int, Eigen::Vector3d>> calculix_steps(const std::string& deck) {
  const TemporaryFolder folder("calculix_loads");
  write_whole(folder.path / "model.inp", deck);
  const std::string command =
      "cd '" + folder.path.string() + "' && OMP_NUM_THREADS=1 ccx -i model >log 2>&1";
  if (std::system(command.c_str()) != 0) return {};
  std::istringstream stream(read_whole(folder.path / "model.dat"));
  std::vector<std::map<int, Eigen::Vector3d>> steps;
  for (std::string line; std::getline(stream, line);) {
    if (line.find("displacements") != std::string::npos) steps.emplace_back();
    std::istringstream fields(line);
    int node = 0;
    Eigen::Vector3d u;
    if (!steps.empty() && fields >> node >> u[0] >> u[1] >> u[2]) steps.back()[node] = u;
  }
  return steps;
}

} // namespace plica::test

// Displacements that CalculiX prints of a deck.
#pragma once

#include "tests/run_calculix.hpp"

#include <Eigen/Core>

#include <map>
#include <sstream>
#include <vector>

namespace plica::test {

// Of the nodes that *NODE PRINT names, step by step; empty where CalculiX is not there.
inline std::vector<std::map<int, Eigen::Vector3d>> calculix_steps(const std::string& deck) {
  std::istringstream stream(calculix_output(deck));
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

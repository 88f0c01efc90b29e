// What is measured of each structure: runs, levels, lines, states, and the head of measured.yaml.
#pragma once

#include "bench.hpp"

namespace sealed {

struct Run {
  int base = 1;
  double level = 5;
  std::string state;
  bool held_out = false;
};

struct Campaign {
  VectorXd lines;
  std::vector<Run> runs;
  std::map<std::string, State> states;
};

Campaign campaign_of(const std::string& structure);

// Keys of measured.yaml.
std::string sensors_of(const std::string& structure);
std::string states_of(const Campaign& c);

} // namespace sealed

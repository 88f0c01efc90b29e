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
  int orders = 2;           // modes listed in each direction and state
  bool only_across = false; // not those that move along or turn about the beam
};

Campaign campaign_of(const Specimen& s);

struct PlacedSensor {
  std::string name, at; // as a case says it
  double mass = 0;      // kg
};
std::vector<PlacedSensor> placed_sensors(const Specimen& s);

// Keys of measured.yaml.
std::string sensors_of(const Specimen& s);
std::string states_of(const Campaign& c);

} // namespace sealed

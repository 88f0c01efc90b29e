// The state in which a part works: bent and stretched by its installation, under pressure, hot,
// under its weight. What a case computes is then computed around it.
#pragma once

#include "model/description/parts.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plica {

// Motion of what holds a cap, from where the part is free of stress: of the cap itself where it is
// held rigidly, of the far ends of its springs where these hold it.
struct EndOffset {
  std::string cap;
  Triple move{}, turn{}; // m; rotation vector, rad
};

// Of constant direction, on a cap that is free or sprung.
struct EndLoad {
  std::string cap;
  Triple force{}, moment{}; // N, Nm
};

// Axial force that a beam bears in the state, whatever else acts: it is tightened until it does.
struct BoltForce {
  std::string part;
  double force = 0; // tension, N
};

// Nodes of a part that are kept at a temperature.
struct HeldTemperature {
  std::string set;
  double temperature = 0; // degC
};

// Gas on one side of a wall, which takes h (T - T_gas) from each area of it.
struct Film {
  double gas = 0;         // degC
  double coefficient = 0; // h, W/(m2 K)
};

// Everywhere the same, over the place, or as heat is conducted along the wall: one of the three.
struct PartTemperature {
  std::string part;
  std::optional<double> at = {};                 // degC
  std::vector<std::array<double, 2>> along = {}; // [y in m, degC], straight in between
  std::vector<HeldTemperature> held = {};
  std::optional<Film> inside = {}, outside = {};

  bool conducted() const { return !held.empty() || inside || outside; }
};

struct OperatingState {
  std::string name; // among `states` of a case; empty: `state`
  std::vector<EndOffset> offset = {};
  std::vector<EndLoad> force = {};
  double pressure = 0; // inside the bellows, above that outside, Pa; caps close the ends
  std::vector<PartTemperature> temperature = {};
  double free_of_stress_at = 20; // degC
  Triple gravity{};              // m/s2
  std::vector<BoltForce> bolt = {};
  int buckling = 0;                 // loads looked for beyond the state
  std::optional<double> yield = {}; // of the formed wall, Pa, for EJMA's in-plane squirm
  bool follow = false;              // by arc length where the load turns back
};

// Is there anything in it that moves the part off its rest?
bool acts(const OperatingState& state);

// Linear between the points. Throws std::out_of_range beyond them.
double at_temperature(const std::vector<std::array<double, 2>>& table, double temperature);

// Lowest and highest that are given: heat that is conducted stays between them.
std::array<double, 2> range_of(const PartTemperature& part);

// At a place along a part whose temperature is given; beyond the ends of `along` that of the end.
double temperature_at(const PartTemperature& part, double y);

} // namespace plica

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

struct PartTemperature {
  std::string part;
  std::optional<double> at = {};                 // degC, everywhere; or
  std::vector<std::array<double, 2>> along = {}; // [y in m, degC], straight in between
};

struct OperatingState {
  std::vector<EndOffset> offset = {};
  std::vector<EndLoad> force = {};
  double pressure = 0; // inside the bellows, above that outside, Pa; caps close the ends
  std::vector<PartTemperature> temperature = {};
  double free_of_stress_at = 20; // degC
  Triple gravity{};              // m/s2
  int buckling = 0;              // loads looked for beyond the state
};

// Linear between the points. Throws std::out_of_range beyond them.
double at_temperature(const std::vector<std::array<double, 2>>& table, double temperature);

// At a place along the part; beyond the ends of `along` the temperature of the end.
double temperature_at(const PartTemperature& part, double y);

// Steels by their number, with the published tables their material has. Empty: not known.
struct Steel {
  const char* name;
  Material material;
  const char* source;
};
const std::vector<Steel>& steels();

// Name of the material that a part is drawn with; empty where it has none.
std::string material_of(const Part& part);

// Materials that parts name and the case does not list, where they are a known steel.
void add_known_steels(const std::vector<Part>& parts, std::map<std::string, Material>& materials);

} // namespace plica

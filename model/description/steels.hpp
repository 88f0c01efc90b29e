// Steels that a case may name by their number, with published tables over temperature.
#pragma once

#include "model/description/parts.hpp"

#include <map>
#include <string>
#include <vector>

namespace plica {

struct Steel {
  const char* name;
  Material material; // with the tables that its source has; empty: not known
  const char* source;
};
const std::vector<Steel>& steels();

// Name of the material that a part is drawn with; empty where it has none.
std::string material_of(const Part& part);

// Materials that parts name and the case does not list, where they are a known steel.
void add_known_steels(const std::vector<Part>& parts, std::map<std::string, Material>& materials);

} // namespace plica

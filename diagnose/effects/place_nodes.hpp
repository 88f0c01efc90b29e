// Where in the mesh a place of an effect lies: for pictures.
#pragma once

#include "diagnose/effects/effect.hpp"

namespace plica {

// Nodes of what the place names: a sensor, a crown, a point, a cap, a mount, a part or several.
// `along`: m along a line, or along either edge of a plate: the nearest node. None where it is
// everywhere, or on the table.
std::vector<int> nodes_at(const Structure& s, const std::string& place,
                          const std::vector<double>& along = {});

} // namespace plica

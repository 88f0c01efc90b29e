// Names of the node sets the parts of a case have, before there is a mesh.
//
// Bellows: left, right, convolution[k], crown[k], root[k] (k from 1; root[n+1] ends the last one),
// cuff.left, cuff.right where there is one, all. Interlock: start, end, all. Plate: edge1..edge4,
// corner1..corner4, all. Beam: start, end, point[k] (k from 1), all.
#pragma once

#include "model/description/case.hpp"

#include <string>
#include <vector>

namespace plica {

// With the name of the part in front, e.g. "bellows.convolution[3]".
std::vector<std::string> set_names(const Case& data);

// Ends a cap may close: those of bellows and beams, the edges of plates.
std::vector<std::string> end_names(const Case& data);

} // namespace plica

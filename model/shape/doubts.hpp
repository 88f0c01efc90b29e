// What a case may say but most likely does not mean: warnings, never errors.
#pragma once

#include "model/shape/build.hpp"

namespace plica {

// One sentence for each: a material of no known kind (a unit forgotten or taken for another), a
// wall without density, an angle of several turns, elements or walls larger than their part, a
// model of kilometres or micrometres, a cap that joins ends far apart, pieces that nothing joins, a
// material that no part uses, a sensor off the wall that it is taken to.
std::vector<std::string> doubts(const Case& data, const BuiltCase& built);

} // namespace plica

// Frequency responses, shapes and signals as data sets of universal files.
//
// Sensor k of the set (in the order of its first channel) is node k + 1 and the entity of that
// name; axis x y z is direction 1 2 3. Frequencies that are not evenly spaced keep their abscissa.
#pragma once

#include "io/universal/file.hpp"
#include "lab/identification/identify.hpp"

namespace plica {

std::vector<UniversalFunction> universal_functions(const FrfSet& set); // type 4 or 5
std::vector<UniversalShape> universal_shapes(const Identification& found);

} // namespace plica

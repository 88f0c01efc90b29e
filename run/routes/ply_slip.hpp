// Plies that stick until they slip, as friction of the bellows as a whole.
#pragma once

#include "model/shape/build.hpp"

namespace plica {

// Laws of a bellows with `wall.slip` from end to end, in axial and bending motion. Their stiffness
// is what the stuck wall has beyond the slipping one, by the shells of that bellows alone. Throws
// InputError when sticking makes it no stiffer.
std::vector<DirectionalLaw> ply_laws(const Case& data, const std::string& bellows);

// The case with its joints slipping, plies included. Throws as build() and ply_laws() do.
BuiltCase slipping_case(const Case& data);

} // namespace plica

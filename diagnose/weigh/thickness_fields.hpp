// Smooth fields of thickness of the walls that a case gives one (Wall::thickness_field), as what
// varies between admissible specimens.
//
// Along a bellows cosines of one to four half waves; over any other wall products of cosines along
// its two longest directions, of up to three half waves together. The mean square of all of them is
// the stated one. Membrane and mass go with the thickness, bending with its cube.
#pragma once

#include "diagnose/effects/effect.hpp"

namespace plica {

// What the case states of a wall that is no bellows.
std::optional<double> field_over(const Part& part);

std::vector<Hypothesis> thickness_fields(const Structure& s);

} // namespace plica

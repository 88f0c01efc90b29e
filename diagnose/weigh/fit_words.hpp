// A fit in words.
#pragma once

#include "diagnose/weigh/hypothesis_fit.hpp"

namespace plica {

// "ply_slip at bellows", "added_mass at beam.point[3] (all round)"; pairs with "and".
std::string name_of(const HypothesisFit& fit);

} // namespace plica

// The whole unreduced model of a case as a Nastran deck: CQUAD4 shells with the bending factor of
// slipping plies in 12I/T^3, CBAR beams, RBE2 spiders, RBE3 ties, MPC
// for places on shells, CONM2 masses, CBUSH springs, SPC1, and modes (SOL 103) or the response to
// motion of the base (SOL 111 with an enforced acceleration per direction). Units: SI.
#pragma once

#include "model/shape/build.hpp"

#include <string>

namespace plica {

// Throws std::runtime_error naming what the deck cannot hold.
std::string nastran_model(const Case& data, const BuiltCase& built);

} // namespace plica

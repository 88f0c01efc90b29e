// A superelement for Nastran: DMIG matrices with a deck around them.
//
// A field of DMIG* holds 12 digits; each matrix is therefore the sum of two, K2GG = KPLICA,
// KPLICAL (likewise M), the second with what the first rounds away. Boundary nodes are GRIDs, modal
// coordinates SPOINTs. Symmetric, lower triangle. With damping also
// B2GG (viscous) and K42GG (structural).
#pragma once

#include "io/superelements/labels.hpp"

namespace plica {

std::string nastran_deck(const Superelement& s, const ElementLabels& labels = {});

// Recovered points as GRIDs that follow the coordinates by MPC, a set that has the number of the
// element.
std::string nastran_recovery(const Superelement& s, const ElementLabels& labels = {});

} // namespace plica

// A superelement for Nastran: DMIG matrices with a deck around them.
//
// Double precision wants the exponent D, which leaves a field of DMIG* 10 digits; each matrix is
// therefore the sum of two, K2GG = KPLICA, KPLICAL (likewise M), the second with what the first
// rounds away. Boundary nodes are GRIDs, modal coordinates SPOINTs. Symmetric, lower triangle. With
// damping also B2GG (viscous) and K42GG (structural).
#pragma once

#include "io/superelements/labels.hpp"

namespace plica {

std::string nastran_deck(const Superelement& s, const ElementLabels& labels = {});

// Recovered points as GRIDs that follow the coordinates by MPC, a set that has the number of the
// element.
std::string nastran_recovery(const Superelement& s, const ElementLabels& labels = {});

// Their motion by the coordinates as a rectangular DMIG, OTMPLICA, transposed, since the rows of a
// DMIG are the points of the deck: columns 6 k + 1 to 6 k + 6 are ux uy uz rx ry rz of point k.
// The sum of OTMPLICA and OTMPLICL, as above. Nothing adds it to a model.
std::string nastran_recovery_matrix(const Superelement& s, const ElementLabels& labels = {});

} // namespace plica

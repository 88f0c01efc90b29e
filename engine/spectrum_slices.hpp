// All modes below a bound by SLEPc's spectrum slicing (Campos & Roman, Numer. Algorithms 60 (2012)
// 279-295): shifts through the interval, each with a factor of K - sigma M by MUMPS, whose inertias
// say how many eigenvalues lie between two shifts.
#pragma once

#include "engine/krylov_schur.hpp"

namespace plica {

// Collective: the eigenvalues in [low, high], low below all of them. The other arguments as in
// krylov_schur(). What the slices counted is noted.
EigenColumns spectrum_slices(const DistributedMatrix& K, const DistributedMatrix& M, double low,
                             double high, const Ranks& ranks, const MumpsSettings& settings);

} // namespace plica

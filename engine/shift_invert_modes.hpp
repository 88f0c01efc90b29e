// The lowest modes of K phi = lambda M phi by SLEPc's Krylov-Schur (Stewart, SIAM J. Matrix Anal.
// Appl. 23 (2001) 601-614; Hernandez, Roman & Vidal, ACM TOMS 31 (2005) 351-362) in shift-invert
// mode, with the proof of solve/modes.hpp: sigma in the widest gap above the modes asked for, and
// as many modes found below it as K - sigma M has negative pivots.
#pragma once

#include "engine/mumps_factor.hpp"
#include "solve/modes.hpp"

#include <map>
#include <optional>

namespace plica {

// Factor of K - sigma M with sigma at or below the whole spectrum: no negative pivot.
struct ShiftedFactor {
  double sigma = 0;
  std::optional<DistributedMatrix> A; // none: K itself
  std::optional<MumpsFactor> factor;
};

// As factor_below_spectrum() of solve/modes.hpp; throws ModelError likewise, on every rank.
ShiftedFactor factor_under_spectrum(const DistributedMatrix& K, const DistributedMatrix& M,
                                    const Ranks& ranks, const MumpsSettings& settings);

struct DistributedModes : ModeSet { // `Phi`: own rows
  MumpsReport counted;              // the factor of the proof
};

// Collective. `base` is released before the proof. Throws ModelError on every rank when nothing has
// mass.
DistributedModes find_modes(const DistributedMatrix& K, const DistributedMatrix& M,
                            const ModesRequest& request, ShiftedFactor& base, const Ranks& ranks,
                            const MumpsSettings& settings);

int dofs_with_mass(const DistributedMatrix& M, const Ranks& ranks);

} // namespace plica

// In which component the nominal stiffness or mass is wrong, by the shapes of modes.
//
// A measured shape y at frequency w is expanded to the one of the model that comes nearest to it
// and leaves the least out of balance (minimum dynamic residual expansion: Balmes, Mech. Syst.
// Signal Process. 14 (2000) 1):
//
//   least  |R|_K^2 / (eps^2 E) + |c q - y|^2 / sigma^2,   R = K^-1 (K - w^2 M) q,   E: of the
//   nominal mode most like it
//
// R stores energy where the forces that are missing act: of each component R' K_c R over its strain
// energy q' K_c q. How unusual that is among admissible specimens is the standard score. Few
// channels cannot place it: then hypotheses at places do.
#pragma once

#include "diagnose/results/diagnosis.hpp"
#include "diagnose/weigh/uncertainty.hpp"

namespace plica {

// Of the measured modes of the specimen as it stands that have a vector over at least
// `fewest_channels`, and for cases of at least two components; else none. Positive z: more than in
// admissible specimens; significant at 5 % after Holm's correction.
std::vector<LocatedGap> residual_energy(const Nominal& nominal, const TestReadings& test,
                                        const Measured& measured);

constexpr std::size_t fewest_channels = 8;

} // namespace plica

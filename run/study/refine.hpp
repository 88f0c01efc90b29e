// The same case on a finer mesh, to estimate the error of its own.
#pragma once

#include "model/description/case.hpp"
#include "run/results/results.hpp"

namespace plica {

// How much finer: elements along the meridian (of plates: edges 1 and 3; of beams: along them) and
// around the circumference (of plates: edges 2 and 4).
struct Refinement {
  double along = 1, around = 1;
};

// Numbers of elements are multiplied and rounded up; a density given as an accuracy becomes counts.
Case refined(Case data, const Refinement& factor);

// Every bellows with half the elements each way, and no fewer than two per arc and wall: for the
// change of a number with a parameter, which a coarse mesh gives nearly as well. Others stay.
Case with_coarse_bellows(Case data);

// Ratio of the elements that `refined` really gives, from the first part that is refined that way;
// 1 when there is none.
Refinement refinement_ratio(const Case& data, const Refinement& factor);

// Most waves around of the listed modes that the mesh of a bellows with an accuracy does not yet
// resolve (model/shape/mesh_choice.hpp); 0 = it resolves them all, or the case says up to how many
// it has to.
int unresolved_waves(const Case& data, const Results& results);

// Every bellows with an accuracy resolves so many waves, where the case does not say how many.
Case resolving(Case data, int waves);

} // namespace plica

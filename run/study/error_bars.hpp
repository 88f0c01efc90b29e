// Error bars of the headline numbers: what the mesh still misses, and what the tolerances of the
// drawing and of assumed numbers leave open.
//
// Mesh: two further runs, one finer along the meridian and one around. With the second order that
// is measured on bellows (docs/elements.md), a number h0 on the mesh of the case and h1 on one
// finer by a ratio q misses (h1 - h0) / (1 - 1/q^2); both directions are given with their sign and
// are not meant to cancel. The peak of the stress is recovered from the strains of one element
// and is of the first order: (h1 - h0) / (1 - 1/q). Modes are found again by their shapes
// (match_modes.hpp). A reduced model is run once more with more modes in every superelement.
//
// Tolerances: each number alone is put to the 5 % and 95 % points of its distribution; a parabola
// through the three results in their logarithm is its effect, taken on a coarse mesh of the
// bellows. The effects are added, 20,000 draws give the 5 % and 95 % points of the result, and the
// variances of the effects their shares. One more run with all numbers drawn at random shows what
// the sum neglects.
#pragma once

#include "model/description/case.hpp"
#include "run/results/results.hpp"
#include "run/stages.hpp"

namespace plica {

// `u` in [0, 1] to the value with that probability below it.
double quantile(const Tolerance& tolerance, double u);

// The case for headline numbers only: no response, no stress, no proof, no sensors without mass.
Case for_headline(Case data);
// `plain`, made for headline numbers, with what the life of `data` needs: stress ranges and damage
// of its duties.
Case with_life(Case plain, const Case& data);
// The same as for_headline() with the motion of the base, for what stands beside measured peaks.
Case for_comparison(const Case& data);

// `stage` is told what runs. `nominal`: results of the case as it stands, from for_headline or
// more. Of its headline numbers, static stiffnesses, modes, stresses at every place, and damages of
// the life ("damage_NAME", "damage"); sweeps with friction solve their joints anew in every run.
ErrorBars error_bars(const Case& data, const Results& nominal, const StageListener& stage);

// The stiffnesses and modes whose mesh error is estimated to be beyond the accuracy that the mesh
// of the bellows was chosen for (model/shape/mesh_choice.hpp), with an accuracy that would do, as a
// warning; empty = none. Peaks of stress are not chosen for.
std::string beyond_accuracy(const Case& data, const Results& results);

} // namespace plica

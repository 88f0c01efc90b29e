// How many elements a bellows gets for an accuracy a, the relative error aimed at in static
// stiffness, in the modes with n = 0 and 1 and, once they are known, in those with n >= 2 waves
// around. Counts that the case gives are left alone. Measured on bellows of many shapes
// (docs/elements.md), a rule and no bound: transverse and bending stiffness of deep bellows, which
// err by up to 13/N^2 around, miss 1.2 a. The error bars of a run tell what came of it.
//
// Around, with N elements, stiffness errs by 7/N^2 (incompatible membrane; 60/N^2 with the others)
// and takes a/2. A mode of n waves errs by (n^2 - 1) (2 pi/N)^2 / 8 in frequency and takes 3a/4,
// for along the meridian it errs the other way or little: bilinear displacements carry (2 + cos
// kh)/3 of the mass of a wave and bend too little by 1 - (kh)^2/12, together (kh)^2/8 of the
// frequency for k h = 2 pi n/N; a translation, n = 1, is exact.
//
// Along, the least is 4 elements per quarter arc and 5 per wall at 0.7 %, falling with the square,
// and more where those are longer than the bending length sqrt(R t); meridian_error() may ask for
// more.
#pragma once

#include "model/description/case.hpp"

namespace plica {

struct ElementCounts {
  int around = 0, arc = 0, wall = 0; // arc: per quarter turn
};
ElementCounts element_counts(const Bellows& bellows);

// The accuracy that its density follows; 0 where counts are given.
double mesh_accuracy(const Bellows& bellows);

// Relative error of the axial stiffness for want of elements along, by what facets do to the U and
// omega convolutions and to discs; the largest of all sections, signed. The bending moment of an
// axial force is proportional to the distance m of the wall from its mean radius, and an element
// bears that of its chord's middle: the stiffness is too high by the share of
// int m^2 ds = sum l m^2 that is lost, which is most where arcs are nearly the whole profile.
// Measured besides: directors that differ by d across an element soften it by d^2/5, a length l by
// the hoop stiffens it by 0.1 l^2/(R t). Off by at most 0.4 of the accuracy for bellows it was
// compared with. Profiles of points: 0, not known.
double meridian_error(const Bellows& bellows, const ElementCounts& counts);

} // namespace plica

// A meridian turned about the y axis: structured quads, exact directors, named sets and rings.
//
// Node (j, k) lies on ring j at the angle 2 pi k / around from x towards z. Corner 1-2 of a quad
// runs along the meridian, corner 2-3 round the axis; directors point outward.
//
// Sets: left, right (end circles), convolution[k], crown[k], root[k] for k = 1..n (and root[n+1],
// where the last one ends), cuff.left, cuff.right, all.
#pragma once

#include "mesh/generation/meridian.hpp"
#include "mesh/mesh.hpp"

#include <functional>

namespace plica {

// `thickness` gives the wall in m at a radius in m. `around` >= 3.
// Throws TooLarge before it makes a mesh that no run could hold.
Mesh revolve(const Meridian& meridian, int around, const std::function<double(double)>& thickness);

} // namespace plica

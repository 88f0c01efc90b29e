// Torsion of a shell of revolution in closed form: the membrane shear flow is T / (2 pi r^2), so
// K_t = 2 pi G t / int r^-3 ds over the meridian (t: whole wall), Nm/rad.
#pragma once

#include "mesh/generation/meridian.hpp"

namespace plica::test {

double torsion_stiffness(const Meridian& meridian, double G, double wall);

} // namespace plica::test

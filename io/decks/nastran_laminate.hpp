// Walls of plies that are, as a whole, isotropic: exactly a wall of one material with other factors
// for bending and shear.
#pragma once

#include "elements/shell_section.hpp"

#include <string>
#include <vector>

namespace plica {

struct LaminatePly {
  double E = 0, nu = 0, rho = 0, G = 0, thickness = 0;
};

// A = sum Q t, D = sum Q (t z^2 + t^3/12) about the middle, which have to share nu within 0.005,
// and no coupling B. Transverse shear from equilibrium of the bent wall: GA = D^2 / integral S^2/G
// dz, S = integral of E/(1-nu^2) z from below; 5/6 G t for one material.
struct IsotropicLaminate {
  ShellSection section;
  double thickness = 0;
  std::string refusal; // why there is none
};
IsotropicLaminate isotropic_laminate(const std::vector<LaminatePly>& plies);

} // namespace plica

// Constitutive law of a shell wall: isotropic, plane stress, one or more plies of one material.
//
//   sigma = E/(1-nu^2) [1 nu 0; nu 1 0; 0 0 (1-nu)/2] eps,   tau = kappa_s E/(2(1+nu)) gamma
//
// Plies with bond fraction b bend with D(b) = D_slip + b (D_solid - D_slip), D_slip the sum of the
// plies' own: 0 = they slip on each other, 1 = one solid wall. Membrane and transverse shear do not
// depend on b. Mass per area rho t, rotary inertia rho t^3/12 (a rigid turn moves the whole wall,
// slip or not).
#pragma once

#include <Eigen/Core>
#include <vector>

namespace plica {

struct ShellSection {
  double E = 0, nu = 0, rho = 0;
  double bending_factor = 1; // D / D_solid: 1 for one wall, 1/n^2 for n equal slipping plies
  double shear_correction = 5. / 6;
  double drilling = 1e-4;    // stiffness that ties the drilling rotation, as a fraction of G
  double thermal_strain = 0; // of the free wall since rest, at a state (elements/element_state.hpp)
};

struct ShellLaw {
  Eigen::Matrix3d in_plane; // Pa
  Eigen::Matrix2d shear;    // Pa, shear correction included
  double drilling = 0;      // Pa
};

ShellLaw shell_law(const ShellSection& section);

// D(b) / D_solid for plies of the given thicknesses (m) and bond fraction b in [0, 1].
double ply_bending_factor(const std::vector<double>& plies, double bond);

} // namespace plica

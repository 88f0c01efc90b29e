// Section properties of a straight beam: resultants per unit strain and inertia per unit length.
//
// Local axes: x along the beam, y and z the principal axes of the section. EI_y resists bending
// about y (deflection along z). GA_y, GA_z are effective shear stiffnesses k G A; infinity = rigid.
// Shear coefficients after Cowper, J. Appl. Mech. 33 (1966) 335-340; torsion after Saint-Venant.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace plica {

struct BeamProperties {
  double EA = 0, EI_y = 0, EI_z = 0, GJ = 0; // N, N m2
  double GA_y = std::numeric_limits<double>::infinity();
  double GA_z = std::numeric_limits<double>::infinity(); // N
  double mass = 0;                                       // kg/m
  double inertia_x = 0, inertia_y = 0, inertia_z = 0;    // rotary inertia per length, kg m
  double thermal_strain = 0; // of the free beam since rest, at a state (elements/element_state.hpp)
  // On the way into a state: the axial force that it bears however long it becomes, as a bolt does
  // while it is tightened, N.
  std::optional<double> tightened = {};
  // Where stress is recovered: [y, z] of outermost fibres, m, and Young's modulus. None for a
  // section given by its stiffness. Of a round one 24 points, so that the largest bending stress is
  // missed by at most 0.9 %.
  std::vector<std::array<double, 2>> fibres = {};
  double E = 0;
};

struct BeamMaterial {
  double E = 0, nu = 0, rho = 0;
};

// Round pipe by its mid-surface radius and wall; exact annulus, Cowper's thin-tube coefficient
// 2(1+nu)/(4+3nu).
BeamProperties pipe_section(const BeamMaterial& material, double radius, double wall);

// Solid round bar, 6(1+nu)/(7+6nu).
BeamProperties round_section(const BeamMaterial& material, double radius);

// Solid rectangle, `width` along y and `depth` along z, 10(1+nu)/(12+11nu).
BeamProperties rectangle_section(const BeamMaterial& material, double width, double depth);

} // namespace plica

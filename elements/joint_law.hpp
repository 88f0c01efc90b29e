// Force of a joint over the relative motion in one direction: springs and dry friction in parallel.
//
//   f(x) = k x + c3 x^3 + g(x) + sum of Jenkins sliders
//
// A Jenkins slider is a spring k_t in series with a friction element of slip force mu:
//   f <- clamp(f + k_t dx, -mu, mu)
// Sliders in parallel are an Iwan model (J. Appl. Mech. 33 (1966) 893) and obey Masing's rule.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace plica {

struct JenkinsSlider {
  double stiffness = 0;  // k_t, N/m or Nm/rad
  double slip_force = 0; // mu, N or Nm
};

struct JointLaw {
  double stiffness = 0; // what is left when all sliders slip
  double cubic = 0;     // N/m3
  // [displacement, force], increasing, straight between points and beyond: piecewise-linear springs,
  // clearance, tabulated connectors. Empty = none.
  std::vector<std::array<double, 2>> curve = {};
  std::vector<JenkinsSlider> sliders = {};

  double stuck_stiffness() const; // slope at rest: all sliders stick
};

// Four-parameter Iwan model (Segalman, J. Appl. Mech. 72 (2005) 752-760): stiffness K_T at rest,
// slip force F_S, exponent chi in (-1, 0], ratio beta >= 0 of the stiffness that goes at macro slip
// to that which goes in micro slip. As `count` sliders whose slip displacements grow geometrically.
struct SegalmanIwan {
  double K_T = 0, F_S = 0, chi = -0.5, beta = 1;
  double pm() const; // displacement of macro slip, m
  double R() const;  // N / m^(chi+2)
  double S() const;  // N/m
};
// Throws std::invalid_argument, naming the parameter, for values out of range.
std::vector<JenkinsSlider> sliders_of(const SegalmanIwan& iwan, int count = 100);

// Force on first loading from rest.
double first_loading(const JointLaw& law, double displacement);

// Forces over one period of periodic motion, in the cycle that repeats. `x`: equal steps of the
// period. `dx`: derivatives of x by any parameters, steps x parameters; the forces come with theirs.
struct PeriodForces {
  Eigen::VectorXd force;
  Eigen::MatrixXd derivative;
};
PeriodForces period_forces(const JointLaw& law, const Eigen::VectorXd& x,
                           const Eigen::MatrixXd& dx);

// Energy that friction takes in a cycle between -amplitude and amplitude: the area of the loop, J.
double loop_energy(const JointLaw& law, double amplitude);

} // namespace plica

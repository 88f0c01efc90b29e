// Force of a joint over the relative motion in one direction: springs and dry friction in parallel.
//
//   f = k x + c3 x^3 + g(x) + F tanh(x' / v) + sum of Jenkins sliders
//
// A Jenkins slider is a spring k_t in series with a friction element of slip force mu:
//   f <- clamp(f + k_t dx, -mu, mu)
// Sliders in parallel are an Iwan model (J. Appl. Mech. 33 (1966) 893) and obey Masing's rule. SI
// units: N and m, or Nm and rad.
//
// Where first loading has moved a joint before, by `offset`, motion and force count from there.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <vector>

namespace plica {

struct JenkinsSlider {
  double stiffness = 0;  // k_t, N/m or Nm/rad
  double slip_force = 0; // mu, N or Nm
};

// Dry friction without a spring, its reversal smoothed: F tanh(x' / v).
struct SmoothedCoulomb {
  double force = 0;    // F
  double velocity = 0; // v, at which three quarters of the force act
};

struct JointLaw {
  double stiffness = 0; // what is left when all sliders slip
  double cubic = 0;     // N/m3
  // [displacement, force], increasing, straight between points and beyond: piecewise-linear
  // springs, clearance, tabulated connectors. Empty = none.
  std::vector<std::array<double, 2>> curve = {};
  std::vector<JenkinsSlider> sliders = {};
  SmoothedCoulomb coulomb = {};
  double offset = 0; // that of the state, m or rad

  double stuck_stiffness() const; // slope at rest: all sliders stick; smoothed Coulomb has none
  bool is_odd() const;            // f(-x, -x') = -f(x, x')
};

// The same law in series with itself: n of them, each with n times the stiffness, under the same
// force move together as the given one.
JointLaw in_series(JointLaw law, int n);

// What a slider bears at the offset.
double force_at_offset(const JointLaw& law, const JenkinsSlider& slider);

// Force without the sliders, and its slopes.
struct ElasticForce {
  double force = 0, by_motion = 0, by_velocity = 0;
};
ElasticForce elastic_force(const JointLaw& law, double x, double velocity);

// Four-parameter Iwan model (Segalman, J. Appl. Mech. 72 (2005) 752-760): stiffness K_T at rest,
// slip force F_S, exponent chi of the density R phi^chi of slip displacements phi up to pm, ratio
// beta >= 0 of the stiffness that goes at macro slip, at pm, to that which goes in micro slip
// before. The density may begin at a smallest share of pm; then chi may be -1 and below, where the
// force grows like the power chi + 2 of the motion. As `count` sliders whose slip displacements
// grow geometrically.
struct SegalmanIwan {
  double K_T = 0, F_S = 0, chi = -0.5, beta = 1;
  double smallest = 0; // of pm
  double pm() const;   // displacement of macro slip, m
  double R() const;    // N / m^(chi+2)
  double S() const;    // N/m
};
// Throws std::invalid_argument, naming the parameter, for values out of range.
std::vector<JenkinsSlider> sliders_of(const SegalmanIwan& iwan, int count = 100);

// Force on first loading from rest, slowly; from the offset, on further loading or unloading. And
// its slope, that of a slider on the point of slipping its stiffness.
double first_loading(const JointLaw& law, double displacement);
double first_loading_slope(const JointLaw& law, double displacement);

// Forces at equal steps of a period of periodic motion, in the cycle that repeats.
Eigen::VectorXd period_forces(const JointLaw& law, const Eigen::VectorXd& x,
                              const Eigen::VectorXd& velocity);

// First harmonic of the force over x = A cos(w t), per amplitude: stiffness and, as its imaginary
// part, loss stiffness. Sliders and cubic spring by their closed forms, the rest by 256 samples.
// The mean stays where the offset is. `slope`: derivative by the amplitude.
struct DescribingFunction {
  std::complex<double> gain, slope;
};
DescribingFunction describing_function(const JointLaw& law, double amplitude, double omega);

// Energy that sliders take in a cycle between -amplitude and amplitude: the area of the loop, J.
double loop_energy(const JointLaw& law, double amplitude);

} // namespace plica

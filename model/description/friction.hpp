// Joints with friction and nonlinear springs, as a case states them. What acts in one direction
// acts in parallel; directions slip independently of each other.
//
// `angular`: N becomes Nm, m becomes rad.
#pragma once

#include "elements/joint_law.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace plica {

template <bool angular> struct SliderLaw { // Jenkins: spring and friction element in series
  double stiffness = 0, slip_force = 0;
};

template <bool angular> struct IwanLaw { // Segalman's four parameters
  double stiffness = 0, slip_force = 0;  // K_T, F_S
  double chi = -0.5, beta = 1;
  double smallest = 0; // slip displacement, of that of macro slip
  int sliders = 20;
};

template <bool angular> struct DryLaw { // elastic dry friction under a normal load
  double stiffness = 0;
  double coefficient = 0, normal_load = 0; // N
  double radius = 1;                       // angular: on which it acts, m
};

template <bool angular> struct SmoothedLaw { // Coulomb friction without a spring, F tanh(x' / v)
  double slip_force = 0, velocity = 0;
};

template <bool angular> struct ClearanceLaw { // a spring beyond a gap on either side
  double gap = 0, stiffness = 0;
};

template <bool angular> struct FrictionLaw {
  std::vector<SliderLaw<angular>> sliders;
  std::optional<IwanLaw<angular>> iwan;
  std::optional<DryLaw<angular>> dry;
  std::optional<SmoothedLaw<angular>> smoothed;
  std::optional<ClearanceLaw<angular>> clearance;
  double cubic = 0;                         // N/m3 or Nm/rad3
  std::vector<std::array<double, 2>> curve; // [motion, force], increasing
};

template <bool angular> JointLaw joint_law(const FrictionLaw<angular>& law);

// Of a slender part along the pipe.
struct SlenderFriction {
  std::optional<FrictionLaw<false>> axial, lateral; // lateral: in x and in z
  std::optional<FrictionLaw<true>> bending, torsion;
};

// Between the coils of an interlock. The laws are those of the whole from end to end; it is cut
// into segments, each with as many times the stiffness and the same slip forces: one between every
// two places where it is tied, or, tied to the caps alone, as many as asked for.
struct InterlockFriction : SlenderFriction {
  int segments = 1;
};

// Of a joint or a mount with springs, in each direction.
struct JointFriction {
  std::optional<FrictionLaw<false>> x, y, z;
  std::optional<FrictionLaw<true>> rx, ry, rz;
};

// Plies that stick to each other until they slip. Stuck, the wall has the bond fraction given here;
// slipping, that of the wall. Slip begins and ends as in an Iwan model over the axial force on the
// bellows; in bending the moment is that of the same forces round the circumference, half their sum
// times the mean radius.
struct PlySlip {
  double bond = 1;       // stuck
  double slip_force = 0; // axial force on the bellows that all plies slip under beyond what the
                         // slipping wall bears
  double chi = -0.5, beta = 1;
  int sliders = 12, segments = 9;
  bool operator==(const PlySlip&) const = default;
};

// Motions a joint can have friction in, each a direction of the part frame: 0..5 = ux .. rz.
struct DirectionalLaw {
  int dof = 0;
  std::string name; // "axial", "lateral", "x", ... as in the case file
  JointLaw law;
};
std::vector<DirectionalLaw> directional_laws(const SlenderFriction& friction);
std::vector<DirectionalLaw> directional_laws(const JointFriction& friction);

} // namespace plica

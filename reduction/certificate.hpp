// What a superelement is worth: its checks against the part it stands for.
#pragma once

#include "reduction/superelement.hpp"

#include <limits>
#include <vector>

namespace plica {

// The part itself, computed without the superelement.
struct PartReference {
  Eigen::Matrix<double, 6, 6> rigid_mass; // r' M r about the origin
  Eigen::MatrixXd static_stiffness;       // condensed onto its first DOFs; empty = not known
  // Force that a rigid motion raises in it, of its size; 0 = the superelement was made of the same
  // matrices and shares their rounding.
  double statics_known_to = 0;
  Eigen::VectorXd free_lambda; // boundary free, increasing, rigid modes included
  // Of each free mode, its motion of the boundary coordinates; empty = not known. Where the
  // frequencies of two shapes cross, it tells which is which.
  Eigen::MatrixXd free_motion;
  Eigen::VectorXd fixed_lambda; // boundary held
  int left_out = 0;             // modes left out on purpose: so many frequencies may be missing
  bool grounded = false;        // a support inside the part: not every rigid motion is free
  Eigen::MatrixXd free_motions; // of such a one, in rigid motions about the origin: 6 x those free
  // Of a preloaded part: what each rigid motion about the first node raises at the boundary, as its
  // end forces turn (boundary coordinates x 6). Empty: it is at rest. Its free frequencies are then
  // those with the first node held, since no rotation is free.
  Eigen::MatrixXd preload;
};

struct FrequencyCheck {
  double full = 0, reduced = 0; // Hz
  double error() const { return reduced / full - 1; }
};

struct Certificate {
  double asymmetry = 0;          // |A - A'| / |A|, the larger of K and M
  double smallest_mass = 0;      // smallest eigenvalue of M / largest: above 0
  int zero_stiffness = 0;        // eigenvalues of K that count as zero
  int rigid = 6;                 // motions that strain nothing: 6 for a free part
  double negative_stiffness = 0; // most negative eigenvalue of K / largest
  double grounding = 0;   // largest force that a rigid motion (1 m, 1 rad) raises / largest of K
  double rigid_modes = 0; // sine of the angle between the lowest six modes and the geometry's
  double coordinates = 0; // m: boundary nodes found from the null space of K, off the true ones
  // Relative; m; relative. Of a part that is held in some directions the mass is that of the
  // motions left, centre and inertia are zero.
  double mass = 0, centre = 0, inertia = 0;
  double statics_known_to = 0; // as far as the part's own stiffness is known: its rounding
  // Largest |dK_ij| / sqrt(K_ii K_jj) against the condensed part; NaN = not compared (not two
  // caps).
  double statics = std::numeric_limits<double>::quiet_NaN();
  std::vector<FrequencyCheck> free, fixed; // elastic ones
  double good_up_to = 0;                   // Hz: below, every free frequency is met within `error`
  double error = 0;
  bool preloaded = false; // `grounding` is against what the end forces raise
  bool passed = false;
  std::vector<std::string> failures; // what did not pass, in words
};

Certificate certificate(const Superelement& element, const PartReference& part);

} // namespace plica

// One mode from the circle it draws in the Nyquist plane (Kennelly and Pancu; Ewins, Modal Testing,
// ch. 4).
//
//   viscous, mobility      Y = i w A / (w_n^2 - w^2 + 2 i zeta w_n w),  diameter |A| / (2 zeta w_n)
//   structural, receptance  a = A / (w_n^2 - w^2 + i eta w_n^2),         diameter |A| / (eta w_n^2)
//
// exact circles; other modes shift them by a constant within the band. With theta the angle at the
// centre from the point of resonance, w^2 = w_n^2 + b g tan(theta / 2), g = w and b = 2 zeta w_n,
// or g = 1 and b = eta w_n^2: frequency, damping and the direction of the point of resonance follow
// from a least-squares fit of this line over all points of the band.
#pragma once

#include "lab/measured/frf_set.hpp"

namespace plica {

enum class DampingModel { viscous, structural };

struct CircleFit {
  double frequency = 0;                 // natural, Hz
  double damping = 0;                   // zeta; eta / 2 of the structural model
  std::complex<double> centre, residue; // residue A, of the displacement per reference
  double radius = 0;
  double misfit = 0; // RMS distance of the points from the circle / radius
  bool good = false;
  std::string reason; // why not good: fewer than five points, no circle, no sweep through it
};

// `values` of one quantity over a band with one mode.
CircleFit fit_circle(const Eigen::VectorXd& hertz, const Eigen::VectorXcd& values,
                     FrfQuantity quantity, DampingModel model);

} // namespace plica

// Damping that the real modes do not uncouple: material loss by part, dashpots, springs whose
// stiffness depends on frequency. On a basis of real modes with residual vectors (Phi' M Phi = I,
// Phi' K Phi = Lambda),
//
//   T(s) q = Phi' F,   T(s) = s^2 + s C + Lambda + i L + sum_k b_k g_k(s) b_k',   s = i omega,
//
// C = diag(2 zeta_j omega_j); L = sum_c eta_c Phi' K_c Phi, the loss of the parts with what couples
// the modes; b_k = Phi' t_k, t_k the relative motion that spring k feels (Phi holds its static
// shape); g_k(s) what is added to the stiffness that is in K. L has no causal form: it is that of
// s = i omega, omega > 0.
#pragma once

#include "solve/frequency_response.hpp"

#include <functional>
#include <vector>

namespace plica {

// N/m or Nm/rad, analytic in s off the negative real axis.
using AddedStiffness = std::function<std::complex<double>(std::complex<double> s)>;

struct DampedSpring {
  int column = 0; // b_k: of ModalModel::input
  AddedStiffness added;
};

struct Dissipation {
  Eigen::MatrixXd loss; // L; empty: the eta of each mode alone
  std::vector<DampedSpring> springs;
  // Of loads that stand for ends that move, by a unit acceleration and so by -1 / omega^2: what
  // that motion alone strains, carried along. Empty: nothing.
  Eigen::MatrixXd carried_loss; // sum_c eta_c Phi' K_c R, coordinates x loads
  Eigen::MatrixXd stretch;      // of the springs, springs x loads

  bool empty() const { return loss.size() == 0 && springs.empty(); }
};

// The response by the poles of what is constant, the springs being joined to it frequency by
// frequency through the receptance at them (Woodbury; Jetmundsen, Bielawa & Flannelly, J. Am.
// Helicopter Soc. 33 (1988) 34-44).
class DissipativeResponse {
public:
  DissipativeResponse(const ModalModel& model, const Dissipation& dissipation);

  // Displacements, frequencies x channels, under the loads times these factors; omega > 0 in rad/s.
  Eigen::MatrixXcd operator()(const std::vector<std::pair<int, std::complex<double>>>& loads,
                              const Eigen::VectorXd& omega) const;

private:
  Eigen::VectorXcd diagonal(double omega) const;

  ModalModel model_;
  std::vector<DampedSpring> springs_;
  bool poles_ = false;            // else the real modes uncouple all that is constant
  Eigen::VectorXcd s_;            // poles
  Eigen::MatrixXcd left_, right_; // channels and springs x terms, terms x loads
  Eigen::MatrixXcd carried_;      // terms x loads, times 1 / omega^2
  Eigen::MatrixXd stretch_;
};

struct ComplexMode {
  std::complex<double> s; // rad/s, Im > 0; frequency |s| / 2 pi, damping -Re s / |s|
  Eigen::VectorXcd q;     // modal coordinates, q' q = 1 (no conjugate)
  double residual = 0;    // |T(s) q| / (|s|^2 |q|)
};

struct ComplexModes {
  std::vector<ComplexMode> modes; // by |s|
  int oscillating = 0;            // poles above the real axis that the linear part has
  int overdamped = 0;             // pairs of real poles in place of an oscillation
  bool complete = false; // oscillating + overdamped is the number of real modes, all of them
                         // converged and different
  std::string reason;    // why not
};

// The `count` lowest: eigenvalues of the state space of all that is constant and of the dashpots,
// followed to T(s) q = 0 by Newton's method (Ruhe, SIAM J. Numer. Anal. 10 (1973) 674-689).
ComplexModes complex_modes(const ModalModel& model, const Dissipation& dissipation, int count);

} // namespace plica

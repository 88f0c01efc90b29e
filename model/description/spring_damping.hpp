// Damping of the six springs of a mount or of a joint between ends, beside their stiffness k (ux uy
// uz rx ry rz):
//
//   k(s) = k (1 + i eta + sum_m g_m s tau_m / (1 + s tau_m) + (s tau)^alpha) + c s,   s = i omega
//
// c: dashpot (Kelvin-Voigt); g_m, tau_m: Maxwell branches, stiffness over k and relaxation time;
// tau, alpha: springpot, fractional Kelvin-Voigt (Bagley & Torvik, AIAA J. 21 (1983) 741-748); or a
// table of k'(f) / k and of the loss factor, straight between its rows and level beyond them.
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <vector>

namespace plica {

struct MaxwellBranch {
  double share = 0; // g, over the static stiffness
  double time = 0;  // tau, s
};

struct Springpot {
  double time = 0; // tau, s
  double exponent = 0.5;
};

struct SpringDamping {
  std::optional<std::array<double, 6>> dashpot; // N s/m, Nm s/rad
  double loss_factor = 0;
  std::vector<MaxwellBranch> maxwell;
  std::optional<Springpot> springpot;
  std::vector<std::array<double, 3>> table; // Hz, stiffness over the static one, loss factor
};

// k(s) - k of spring `dof` (0..5) whose static stiffness is k.
std::complex<double> added_stiffness(const SpringDamping& damping, int dof, double k,
                                     std::complex<double> s);

} // namespace plica

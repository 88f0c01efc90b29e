// Timoshenko's beam in closed form, by transfer matrices: what bends in one plane over stretches of
// constant section, with springs and masses on it. No mesh and no code of the library.
#pragma once

#include <Eigen/LU>
#include <unsupported/Eigen/MatrixFunctions>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace plica::beam_roots {

// In SI. Shear stiffness GA with its factor; mass and rotary inertia per length.
struct Stretch {
  double length = 0, EI = 0, GA = 0, mass = 0, inertia = 0;
};

// What holds the axis at a point, moving (k, N/m) and turning (k_turning, Nm/rad), and sits on it.
struct Attached {
  double at = 0, k = 0, mass = 0, k_turning = 0;
};

struct BentBeam {
  std::vector<Stretch> stretches;
  std::vector<Attached> attached;
  bool clamped = false; // at its start; its end is free
};

// A solid rectangle of steel, nu = 0.3, shear factor 10 (1 + nu) / (12 + 11 nu) (Cowper, Journal of
// Applied Mechanics 33, 1966). `deep`: its height in the plane of bending.
inline Stretch rectangle(double length, double wide, double deep, double E) {
  constexpr double nu = 0.3, rho = 7850;
  const double A = wide * deep, I = wide * deep * deep * deep / 12;
  const double factor = 10 * (1 + nu) / (12 + 11 * nu);
  return {length, E * I, factor * E / (2 * (1 + nu)) * A, rho * A, rho * I};
}

// Over a stretch, of the state (w / L, psi, M L / EI, V L^2 / EI), L and EI those of the stretch:
//   w' = psi + V / GA,  psi' = M / EI,  M' = -V - rho I omega^2 psi,  V' = -rho A omega^2 w.
// `part`: how much of it is gone along.
inline Eigen::Matrix4d along(const Stretch& s, double part, double omega2) {
  const double L = s.length, unit = s.EI / (L * L);
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  A(0, 1) = A(1, 2) = 1;
  A(0, 3) = unit / s.GA;
  A(2, 3) = -1;
  A(2, 1) = -s.inertia * omega2 / unit;
  A(3, 0) = -s.mass * omega2 * L * L / unit;
  const Eigen::Vector4d size(L, 1, s.EI / L, unit); // of the state in SI
  const Eigen::Matrix4d moved = Eigen::Matrix4d(A * part).exp();
  return size.asDiagonal() * moved * size.cwiseInverse().asDiagonal();
}

// Moment and shear at the free end for what is open at the start: zero at a frequency.
inline double determinant(const BentBeam& beam, double hertz) {
  const double omega2 = std::pow(2 * std::numbers::pi * hertz, 2);
  Eigen::Matrix<double, 4, 2> z = Eigen::Matrix<double, 4, 2>::Zero();
  for (int k = 0; k < 2; ++k) z(beam.clamped ? 2 + k : k, k) = 1;
  const auto pass = [&](double place) {
    for (const Attached& a : beam.attached)
      if (std::abs(a.at - place) < 1e-9) {
        z.row(3) += (a.k - a.mass * omega2) * z.row(0);
        z.row(2) += a.k_turning * z.row(1);
      }
  };
  double here = 0;
  pass(here);
  for (const Stretch& s : beam.stretches)
    for (const double end = here + s.length; here < end;) {
      double next = end;
      for (const Attached& a : beam.attached)
        if (a.at > here) next = std::min(next, a.at);
      z = along(s, (next - here) / s.length, omega2) * z;
      here = next;
      pass(here);
    }
  return z.bottomRows<2>().determinant();
}

// The first `count` frequencies above `low`, Hz; neighbours have to lie a hundredth apart.
inline std::vector<double> frequencies(const BentBeam& beam, double low, std::size_t count) {
  std::vector<double> found;
  constexpr double step = 1.01;
  for (double f = low, before = determinant(beam, low); found.size() < count; f *= step) {
    const double after = determinant(beam, f * step);
    if (before * after < 0) {
      double a = f, b = f * step;
      for (int i = 0; i < 45; ++i) {
        const double middle = (a + b) / 2;
        (before * determinant(beam, middle) > 0 ? a : b) = middle;
      }
      found.push_back(a);
    }
    before = after;
  }
  return found;
}

} // namespace plica::beam_roots

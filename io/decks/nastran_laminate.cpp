#include "io/decks/nastran_laminate.hpp"

#include <cmath>

namespace plica {

IsotropicLaminate isotropic_laminate(const std::vector<LaminatePly>& plies) {
  double t = 0, mass = 0;
  for (const LaminatePly& p : plies) {
    t += p.thickness;
    mass += p.rho * p.thickness;
  }
  double A = 0, A12 = 0, B = 0, D = 0, D12 = 0, z = -t / 2;
  for (const LaminatePly& p : plies) {
    const double Q = p.E / (1 - p.nu * p.nu), middle = z + p.thickness / 2;
    const double second = p.thickness * (middle * middle + p.thickness * p.thickness / 12);
    A += Q * p.thickness;
    A12 += p.nu * Q * p.thickness;
    B += Q * p.thickness * middle;
    D += Q * second;
    D12 += p.nu * Q * second;
    z += p.thickness;
  }
  const double nu = A12 / A;
  if (std::abs(B) > 1e-6 * A * t)
    return {{}, t, "is not symmetric about its middle: it couples membrane and bending"};
  if (std::abs(D12 / D - nu) > 0.005)
    return {{}, t, "bends with another nu than it stretches with"};
  double S = 0, flexibility = 0; // integral of S^2/G, S quadratic in z within a ply
  z = -t / 2;
  for (const LaminatePly& p : plies) {
    const double Q = p.E / (1 - p.nu * p.nu), h = p.thickness;
    const double b = Q * z, c = Q / 2; // S + b x + c x^2, x from the lower face of the ply
    flexibility += (S * S * h + S * b * h * h + (b * b + 2 * S * c) * h * h * h / 3 +
                    b * c * std::pow(h, 4) / 2 + c * c * std::pow(h, 5) / 5) /
                   p.G;
    S += b * h + c * h * h;
    z += h;
  }
  IsotropicLaminate all{{}, t, ""};
  all.section = {.E = A / t * (1 - nu * nu), .nu = nu, .rho = mass / t};
  all.section.bending_factor = D / (A / t * t * t * t / 12);
  const double G = all.section.E / (2 * (1 + nu));
  all.section.shear_correction = D * D / flexibility / (G * t);
  return all;
}

} // namespace plica

// Walls of plies: as a wall of one material with other factors for bending and shear where they
// are, as a whole, isotropic; in general as forces and moments over strains and curvatures.
#pragma once

#include "elements/shell_laminate.hpp"
#include "elements/shell_section.hpp"

#include <string>
#include <vector>

namespace plica {

struct LaminatePly {
  double E = 0, nu = 0, rho = 0, G = 0, thickness = 0;
};

// A = sum Q t, D = sum Q (t z^2 + t^3/12) about the middle, which have to share nu within 0.005,
// and no coupling B. Transverse shear from equilibrium of the bent wall: GA = D^2 / integral S^2/G
// dz, S = integral of E/(1-nu^2) z from below; 5/6 G t for one material.
struct IsotropicLaminate {
  ShellSection section;
  double thickness = 0;
  std::string refusal; // why there is none
};
IsotropicLaminate isotropic_laminate(const std::vector<LaminatePly>& plies);

// A material in plane stress, along its own axes.
struct PlyMaterial {
  Eigen::Matrix3d Q = Eigen::Matrix3d::Zero(); // stress over strain (11, 22, 12)
  Eigen::Matrix2d G = Eigen::Matrix2d::Zero(); // transverse shear 13, 23; a diagonal of 0: rigid
  double rho = 0;
};
PlyMaterial orthotropic(double E1, double E2, double nu12, double G12, double G13, double G23,
                        double rho);
inline PlyMaterial isotropic(double E, double nu, double G, double rho) {
  return orthotropic(E, E, nu, G, G, G, rho);
}
bool is_material(const PlyMaterial& material); // positive definite, density not below zero

constexpr double rigid_in_shear = 1e3; // times 5/6 of the shear stiffness in the plane

// A wall of one material all through.
ShellLaminate solid_wall(const PlyMaterial& material);

struct GeneralPly {
  PlyMaterial material;
  double thickness = 0, angle = 0; // rad, of its axis 1 from that of the wall
};
// Plies from below (against the normal) upwards, about the middle of the wall. Transverse shear
// along either axis by itself: (sum Q11 (z - zn)^2)^2 / integral of S^2/G, S from below about the
// neutral plane zn.
ShellLaminate general_laminate(const std::vector<GeneralPly>& plies);

} // namespace plica

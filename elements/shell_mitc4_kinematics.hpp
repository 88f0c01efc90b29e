// Kinematics of MITC4, as elements/shell_mitc4.hpp describes them: shared by the element at rest
// and the element at a state (elements/shell_mitc4_state.hpp).
#pragma once

#include "elements/membrane_strain.hpp"
#include "elements/shell_geometry.hpp"
#include "elements/shell_lamina.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace plica::mitc4 {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Row = Eigen::Matrix<double, 1, 24>;
using Matrix3x24 = Eigen::Matrix<double, 3, 24>;

inline const Vector4d corner_r{-1, 1, 1, -1};
inline const Vector4d corner_s{-1, -1, 1, 1};
inline const double gauss_point = 1 / std::sqrt(3.);

struct Shape {
  Vector4d N, dr, ds;
};

inline Shape shape_functions(double r, double s) {
  const auto R = (1 + r * corner_r.array()).eval(), S = (1 + s * corner_s.array()).eval();
  return {.N = R * S / 4, .dr = corner_r.array() * S / 4, .ds = corner_s.array() * R / 4};
}

// Area of the mid-surface per unit r s.
inline double area(const ShellGeometry& g, const Shape& n) {
  const Vector3d x_r = g.X * n.dr, x_s = g.X * n.ds;
  return x_r.cross(x_s).norm();
}

// Covariant membrane strains e_rr, e_ss, 2 e_rs from the bilinear displacements.
inline Matrix3x24 displacement_membrane(const ShellGeometry& g, double r, double s) {
  const Shape n = shape_functions(r, s);
  const Vector3d x_r = g.X * n.dr, x_s = g.X * n.ds;
  Row rr = Row::Zero(), ss = Row::Zero(), rs = Row::Zero();
  add_translation(rr, x_r, n.dr);
  add_translation(ss, x_s, n.ds);
  add_translation(rs, x_r, n.ds);
  add_translation(rs, x_s, n.dr);
  Matrix3x24 e;
  e << rr, ss, rs;
  return e;
}

// Membrane strains of MITC4+ at (r, s) are these multiples (rows rr, ss, 2 rs) of those tied at
// A (0,1), B (0,-1), C (1,0), D (-1,0), E (0,0): rr_A rr_B ss_C ss_D rs_E.
using MembraneTies = Eigen::Matrix<double, 3, 5>;

inline MembraneTies membrane_ties(const ShellGeometry& g, double r, double s) {
  const Vector3d x_r = g.X * corner_r / 4, x_s = g.X * corner_s / 4;
  const Vector3d x_d = g.X * corner_r.cwiseProduct(corner_s) / 4;
  const Vector3d n = x_r.cross(x_s).normalized();
  const double area = x_r.cross(x_s).norm();
  const double c_r = x_d.dot(x_s.cross(n)) / area, c_s = x_d.dot(n.cross(x_r)) / area;
  const double d = c_r * c_r + c_s * c_s - 1;
  const double a_A = c_r * (c_r - 1) / (2 * d), a_B = c_r * (c_r + 1) / (2 * d);
  const double a_C = c_s * (c_s - 1) / (2 * d), a_D = c_s * (c_s + 1) / (2 * d);
  const double a_E = 2 * c_r * c_s / d;
  const double r2 = r * r - 1, s2 = s * s - 1, rs = r * s;
  MembraneTies ties;
  ties << (1 - 2 * a_A + s + 2 * a_A * s * s) / 2, (1 - 2 * a_B - s + 2 * a_B * s * s) / 2,
      s2 * a_C, s2 * a_D, s2 * a_E, //
      r2 * a_A, r2 * a_B, (1 - 2 * a_C + r + 2 * a_C * r * r) / 2,
      (1 - 2 * a_D - r + 2 * a_D * r * r) / 2, r2 * a_E, //
      (r + 4 * a_A * rs) / 2, (-r + 4 * a_B * rs) / 2, (s + 4 * a_C * rs) / 2,
      (-s + 4 * a_D * rs) / 2, 2 * (1 + a_E * rs);
  return ties;
}

inline Eigen::Matrix<double, 5, 24> tied_membrane(const ShellGeometry& g) {
  Eigen::Matrix<double, 5, 24> tied;
  tied << displacement_membrane(g, 0, 1).row(0), displacement_membrane(g, 0, -1).row(0),
      displacement_membrane(g, 1, 0).row(1), displacement_membrane(g, -1, 0).row(1),
      displacement_membrane(g, 0, 0).row(2) / 2;
  return tied;
}

// Covariant transverse shear 2 e_rz at (r, s), and 2 e_sz with the roles exchanged.
inline Row covariant_shear(const ShellGeometry& g, double r, double s, bool along_r) {
  const Shape n = shape_functions(r, s);
  const Vector4d& d = along_r ? n.dr : n.ds;
  Row row = Row::Zero();
  add_translation(row, g.directors * n.N, d);
  add_director(row, g.X * d, n.N, g.directors);
  return row;
}

// In-plane covariant strains e + z k + z^2 q and the tied transverse shear at (r, s).
struct CovariantStrain {
  Matrix3x24 e, k, q;                 // rr, ss, 2 rs
  Eigen::Matrix<double, 2, 24> shear; // 2 rz, 2 sz
};

inline CovariantStrain covariant_strain(const ShellGeometry& g, MembraneStrain choice, double r,
                                        double s) {
  const Shape n = shape_functions(r, s);
  const Vector3d x_r = g.X * n.dr, x_s = g.X * n.ds;
  const Vector3d V_r = g.directors * n.dr, V_s = g.directors * n.ds;
  const auto row = [&](const Vector3d& x, const Vector4d& dw, const Vector3d& V,
                       const Vector4d& du) {
    Row both = Row::Zero();
    add_director(both, x, dw, g.directors);
    add_translation(both, V, du);
    return both;
  };
  const auto director_row = [&](const Vector3d& V, const Vector4d& dw) {
    Row one = Row::Zero();
    add_director(one, V, dw, g.directors);
    return one;
  };
  CovariantStrain c;
  c.e = choice == MembraneStrain::mitc4_plus ? Matrix3x24(membrane_ties(g, r, s) * tied_membrane(g))
                                             : displacement_membrane(g, r, s);
  c.k << row(x_r, n.dr, V_r, n.dr), row(x_s, n.ds, V_s, n.ds),
      row(x_r, n.ds, V_r, n.ds) + row(x_s, n.dr, V_s, n.dr);
  c.q << director_row(V_r, n.dr), director_row(V_s, n.ds),
      director_row(V_r, n.ds) + director_row(V_s, n.dr);
  c.shear << (1 + s) / 2 * covariant_shear(g, 0, 1, true) +
                 (1 - s) / 2 * covariant_shear(g, 0, -1, true),
      (1 + r) / 2 * covariant_shear(g, 1, 0, false) +
          (1 - r) / 2 * covariant_shear(g, -1, 0, false);
  return c;
}

inline LaminaFrame local_frame(const ShellGeometry& g, MembraneStrain membrane, const Shape& n,
                               double z) {
  Matrix3d G;
  G << (g.X + z * g.directors) * n.dr, (g.X + z * g.directors) * n.ds, g.directors * n.N;
  LaminaFrame f = lamina_frame(G, g.X * corner_r); // one direction for the whole element
  if (membrane == MembraneStrain::incompatible) f.volume /= G.col(2).norm(); // keeps its thickness
  return f;
}

inline ShellStrain<24> local_strain(const CovariantStrain& c, const LaminaFrame& f, double z) {
  const Matrix3x24 in_plane = c.e + z * c.k + z * z * c.q;
  return {.in_plane = f.in_plane * in_plane,
          .shear = f.shear * c.shear + f.into_shear * in_plane,
          .basis = f.basis,
          .volume = f.volume};
}

inline Row drilling_strain(const ShellGeometry& g, const Shape& n) {
  return drilling_row<4>(g.X * n.dr, g.X * n.ds, n.N, n.dr, n.ds);
}

using Matrix3x4 = Eigen::Matrix<double, 3, 4>;
using Matrix4x24 = Eigen::Matrix<double, 4, 24>;

inline LaminaFrame centre_frame(const ShellGeometry& g) {
  return local_frame(g, MembraneStrain::incompatible, shape_functions(0, 0), 0);
}

// Internal membrane modes at (r, s), scaled so that they do no work on a constant stress.
inline Matrix3x4 internal_modes(const LaminaFrame& centre, double r, double s, double volume) {
  Matrix3x4 covariant = Matrix3x4::Zero();
  covariant(0, 0) = r;
  covariant(1, 1) = s;
  covariant(2, 2) = r;
  covariant(2, 3) = s;
  return centre.volume / volume * centre.in_plane * covariant;
}

} // namespace plica::mitc4

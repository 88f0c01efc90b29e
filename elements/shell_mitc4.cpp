#include "elements/shell_mitc4.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <cmath>

namespace plica {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Row = Eigen::Matrix<double, 1, 24>;
using Matrix3x24 = Eigen::Matrix<double, 3, 24>;

const Vector4d corner_r{-1, 1, 1, -1};
const Vector4d corner_s{-1, -1, 1, 1};
const double gauss_point = 1 / std::sqrt(3.);

struct Shape {
  Vector4d N, dr, ds;
};

Shape shape_functions(double r, double s) {
  const auto R = (1 + r * corner_r.array()).eval(), S = (1 + s * corner_s.array()).eval();
  return {.N = R * S / 4, .dr = corner_r.array() * S / 4, .ds = corner_s.array() * R / 4};
}

// Area of the mid-surface per unit r s.
double area(const ShellGeometry& g, const Shape& n) {
  const Vector3d x_r = g.X * n.dr, x_s = g.X * n.ds;
  return x_r.cross(x_s).norm();
}

// Covariant membrane strains e_rr, e_ss, 2 e_rs from the bilinear displacements.
Matrix3x24 displacement_membrane(const ShellGeometry& g, double r, double s) {
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

// Covariant membrane strains of MITC4+: tied at A (0,1), B (0,-1), C (1,0), D (-1,0), E (0,0).
Matrix3x24 mitc4_plus_membrane(const ShellGeometry& g, double r, double s) {
  const Vector3d x_r = g.X * corner_r / 4, x_s = g.X * corner_s / 4;
  const Vector3d x_d = g.X * corner_r.cwiseProduct(corner_s) / 4;
  const Vector3d n = x_r.cross(x_s).normalized();
  const double area = x_r.cross(x_s).norm();
  const double c_r = x_d.dot(x_s.cross(n)) / area, c_s = x_d.dot(n.cross(x_r)) / area;
  const double d = c_r * c_r + c_s * c_s - 1;
  const double a_A = c_r * (c_r - 1) / (2 * d), a_B = c_r * (c_r + 1) / (2 * d);
  const double a_C = c_s * (c_s - 1) / (2 * d), a_D = c_s * (c_s + 1) / (2 * d);
  const double a_E = 2 * c_r * c_s / d;

  const Row rr_A = displacement_membrane(g, 0, 1).row(0);
  const Row rr_B = displacement_membrane(g, 0, -1).row(0);
  const Row ss_C = displacement_membrane(g, 1, 0).row(1);
  const Row ss_D = displacement_membrane(g, -1, 0).row(1);
  const Row rs_E = displacement_membrane(g, 0, 0).row(2) / 2;
  const double r2 = r * r - 1, s2 = s * s - 1, rs = r * s;
  Matrix3x24 e;
  e.row(0) = (1 - 2 * a_A + s + 2 * a_A * s * s) / 2 * rr_A +
             (1 - 2 * a_B - s + 2 * a_B * s * s) / 2 * rr_B +
             s2 * (a_C * ss_C + a_D * ss_D + a_E * rs_E);
  e.row(1) = (1 - 2 * a_C + r + 2 * a_C * r * r) / 2 * ss_C +
             (1 - 2 * a_D - r + 2 * a_D * r * r) / 2 * ss_D +
             r2 * (a_A * rr_A + a_B * rr_B + a_E * rs_E);
  e.row(2) =
      2 * ((r + 4 * a_A * rs) / 4 * rr_A + (-r + 4 * a_B * rs) / 4 * rr_B +
           (s + 4 * a_C * rs) / 4 * ss_C + (-s + 4 * a_D * rs) / 4 * ss_D + (1 + a_E * rs) * rs_E);
  return e;
}

// Covariant transverse shear 2 e_rz at (r, s), and 2 e_sz with the roles exchanged.
Row covariant_shear(const ShellGeometry& g, double r, double s, bool along_r) {
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

CovariantStrain covariant_strain(const ShellGeometry& g, MembraneStrain choice, double r,
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
  c.e = choice == MembraneStrain::mitc4_plus ? mitc4_plus_membrane(g, r, s)
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

LaminaFrame local_frame(const ShellGeometry& g, MembraneStrain membrane, const Shape& n, double z) {
  Matrix3d G;
  G << (g.X + z * g.directors) * n.dr, (g.X + z * g.directors) * n.ds, g.directors * n.N;
  LaminaFrame f = lamina_frame(G, g.X * corner_r); // one direction for the whole element
  if (membrane == MembraneStrain::incompatible) f.volume /= G.col(2).norm(); // keeps its thickness
  return f;
}

ShellStrainMatrix local_strain(const CovariantStrain& c, const LaminaFrame& f, double z) {
  const Matrix3x24 in_plane = c.e + z * c.k + z * z * c.q;
  return {.in_plane = f.in_plane * in_plane,
          .shear = f.shear * c.shear + f.into_shear * in_plane,
          .basis = f.basis,
          .volume = f.volume};
}

Row drilling_strain(const ShellGeometry& g, const Shape& n) {
  return drilling_row<4>(g.X * n.dr, g.X * n.ds, n.N, n.dr, n.ds);
}

using Matrix3x4 = Eigen::Matrix<double, 3, 4>;
using Matrix4x24 = Eigen::Matrix<double, 4, 24>;

LaminaFrame centre_frame(const ShellGeometry& g) {
  return local_frame(g, MembraneStrain::incompatible, shape_functions(0, 0), 0);
}

// Internal membrane modes at (r, s), scaled so that they do no work on a constant stress.
Matrix3x4 internal_modes(const LaminaFrame& centre, double r, double s, double volume) {
  Matrix3x4 covariant = Matrix3x4::Zero();
  covariant(0, 0) = r;
  covariant(1, 1) = s;
  covariant(2, 2) = r;
  covariant(2, 3) = s;
  return centre.volume / volume * centre.in_plane * covariant;
}

// Amplitudes of the internal modes per nodal displacement, from their own equilibrium.
Matrix4x24 internal_amplitudes(const ShellGeometry& g, const ShellSection& section,
                               const std::vector<ShellPoint>& points) {
  const LaminaFrame centre = centre_frame(g);
  const Matrix3d C = shell_law(section).in_plane;
  Eigen::Matrix4d K_aa = Eigen::Matrix4d::Zero();
  Matrix4x24 K_au = Matrix4x24::Zero();
  for (const ShellPoint& p : points) {
    const Matrix3x4 modes = internal_modes(centre, p.r, p.s, p.strain.volume);
    K_aa += p.weight * modes.transpose() * C * modes;
    K_au += p.weight * modes.transpose() * C * p.strain.in_plane;
  }
  return -K_aa.inverse() * K_au;
}

std::vector<ShellPoint> compatible_points(const ShellGeometry& g, const ShellSection& section,
                                          MembraneStrain membrane) {
  std::vector<ShellPoint> points;
  for (int i = 0; i < 4; ++i) {
    const double r = gauss_point * corner_r[i], s = gauss_point * corner_s[i];
    const Shape n = shape_functions(r, s);
    const CovariantStrain c = covariant_strain(g, membrane, r, s);
    const double t = g.thickness.dot(n.N);
    for (double side : {-1., 1.}) {
      const double z = side * std::sqrt(section.bending_factor) * t / 2 * gauss_point;
      ShellPoint p{.r = r, .s = s, .z = z, .weight = 0, .strain = {}};
      p.strain = local_strain(c, local_frame(g, membrane, n, z), z);
      p.weight = p.strain.volume * t / 2;
      points.push_back(p);
    }
  }
  return points;
}

} // namespace

std::vector<ShellPoint> shell_mitc4_points(const ShellGeometry& g, const ShellSection& section,
                                           MembraneStrain membrane) {
  std::vector<ShellPoint> points = compatible_points(g, section, membrane);
  if (membrane != MembraneStrain::incompatible) return points;
  const LaminaFrame centre = centre_frame(g);
  const Matrix4x24 amplitudes = internal_amplitudes(g, section, points);
  for (ShellPoint& p : points)
    p.strain.in_plane += internal_modes(centre, p.r, p.s, p.strain.volume) * amplitudes;
  return points;
}

ShellStrainMatrix shell_mitc4_strain(const ShellGeometry& g, const ShellSection& section,
                                     MembraneStrain membrane, double r, double s, double z) {
  const Shape n = shape_functions(r, s);
  ShellStrainMatrix B =
      local_strain(covariant_strain(g, membrane, r, s), local_frame(g, membrane, n, z), z);
  if (membrane != MembraneStrain::incompatible) return B;
  const LaminaFrame centre = centre_frame(g);
  B.in_plane += internal_modes(centre, r, s, B.volume) *
                internal_amplitudes(g, section, compatible_points(g, section, membrane));
  return B;
}

Matrix24 shell_mitc4_stiffness(const ShellGeometry& g, const ShellSection& section,
                               MembraneStrain membrane) {
  const ShellLaw law = shell_law(section);
  Matrix24 K = Matrix24::Zero();
  for (const ShellPoint& p : shell_mitc4_points(g, section, membrane)) {
    Eigen::Matrix<double, 5, 24> strain, stress;
    strain << p.strain.in_plane, p.strain.shear;
    stress << law.in_plane * p.strain.in_plane, law.shear * p.strain.shear;
    K.noalias() += p.weight * strain.transpose() * stress;
  }
  for (int i = 0; i < 4; ++i) {
    const Shape n = shape_functions(gauss_point * corner_r[i], gauss_point * corner_s[i]);
    const double dA = area(g, n);
    const Row drilling = drilling_strain(g, n);
    K.noalias() += law.drilling * g.thickness.dot(n.N) * dA * drilling.transpose() * drilling;
  }
  return (K + K.transpose()) / 2;
}

Matrix24 shell_mitc4_mass(const ShellGeometry& g, const ShellSection& section) {
  Matrix24 M = Matrix24::Zero();
  for (int p = 0; p < 4; ++p) {
    const Shape n = shape_functions(gauss_point * corner_r[p], gauss_point * corner_s[p]);
    const double t = g.thickness.dot(n.N);
    const double dA = area(g, n);
    Matrix3x24 u = Matrix3x24::Zero(), w = Matrix3x24::Zero();
    for (int i = 0; i < 4; ++i) {
      u.block<3, 3>(0, 6 * i) = n.N[i] * Matrix3d::Identity();
      const Vector3d V = n.N[i] * g.directors.col(i);
      w.block<3, 3>(0, 6 * i + 3) << 0, V.z(), -V.y(), -V.z(), 0, V.x(), V.y(), -V.x(), 0;
    }
    M.noalias() += section.rho * dA * (t * u.transpose() * u + t * t * t / 12 * w.transpose() * w);
  }
  return M;
}

Eigen::Matrix<double, 48, 24> shell_mitc4_face_stress(const ShellGeometry& g,
                                                      const ShellSection& section,
                                                      MembraneStrain membrane) {
  const bool internal = membrane == MembraneStrain::incompatible;
  const LaminaFrame centre = centre_frame(g);
  Matrix4x24 amplitudes = Matrix4x24::Zero();
  if (internal)
    amplitudes = internal_amplitudes(g, section, compatible_points(g, section, membrane));
  const Matrix3d C = shell_law(section).in_plane;
  const double fibre = std::sqrt(section.bending_factor) / 2; // of one ply, see above
  Eigen::Matrix<double, 48, 24> stress;
  for (int corner = 0; corner < 4; ++corner) {
    const double r = corner_r[corner], s = corner_s[corner];
    const Shape n = shape_functions(r, s);
    const CovariantStrain c = covariant_strain(g, membrane, r, s);
    for (int face : {0, 1}) {
      const double z = (face == 0 ? -fibre : fibre) * g.thickness[corner];
      const LaminaFrame f = local_frame(g, membrane, n, z);
      Matrix3x24 strain = local_strain(c, f, z).in_plane;
      if (internal) strain += internal_modes(centre, r, s, f.volume) * amplitudes;
      stress.middleRows<6>(12 * corner + 6 * face) = stress_to_global(f.basis) * C * strain;
    }
  }
  return stress;
}

Eigen::Matrix<double, 24, 1> shell_mitc4_area_load(const ShellGeometry& g, const Vector3d& load) {
  Eigen::Matrix<double, 24, 1> F = Eigen::Matrix<double, 24, 1>::Zero();
  for (int p = 0; p < 4; ++p) {
    const Shape n = shape_functions(gauss_point * corner_r[p], gauss_point * corner_s[p]);
    const double dA = area(g, n);
    for (int i = 0; i < 4; ++i) F.segment<3>(6 * i) += n.N[i] * dA * load;
  }
  return F;
}

} // namespace plica

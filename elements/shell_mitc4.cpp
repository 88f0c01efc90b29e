#include "elements/shell_mitc4.hpp"

#include "elements/shell_mitc4_kinematics.hpp"

#include <Eigen/LU>

namespace plica {

using namespace mitc4;

namespace {

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
  points.reserve(8);
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

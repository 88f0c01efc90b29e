// What the shell elements share: rows of strain over nodal displacements, and the Cartesian basis
// of a lamina with the maps of covariant strains into it.
//
//   x(r,s,z) = sum N_i (X_i + z V_i),   u(r,s,z) = sum N_i (u_i + z theta_i x V_i)
//
// r, s are natural coordinates, z is the distance from the mid-surface in m. Third axis of a
// lamina: normal of the surface z = const, so that directors, which are not normal to the facet,
// tilt in-plane strain into the transverse shear but not the other way round.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace plica {

// Strains at one point from the nodal displacements, six a node in global axes.
template <int dofs> struct ShellStrain {
  Eigen::Matrix<double, 3, dofs> in_plane; // eps11 eps22 gamma12
  Eigen::Matrix<double, 2, dofs> shear;    // gamma13 gamma23
  Eigen::Matrix3d basis;                   // columns e1 e2 e3
  double volume = 0;                       // per unit r s z, m2
};

// An integration point: strain energy = 1/2 sum weight (strain' C strain).
template <int dofs> struct ShellSample {
  double r = 0, s = 0, z = 0; // natural coordinates, distance from the mid-surface in m
  double weight = 0;          // m3
  ShellStrain<dofs> strain;
};

struct LaminaFrame {
  Eigen::Matrix3d basis;                  // columns e1 e2 e3
  Eigen::Matrix3d in_plane;               // (rr, ss, 2rs) -> (11, 22, 2*12)
  Eigen::Matrix<double, 2, 3> into_shear; // (rr, ss, 2rs) -> (2*13, 2*23)
  Eigen::Matrix2d shear;                  // (2rz, 2sz) -> (2*13, 2*23)
  double volume = 0;                      // per unit r s z
};

// From the base vectors g_r, g_s, g_z in the columns of G; e1 lies along `along`, seen from e3.
LaminaFrame lamina_frame(const Eigen::Matrix3d& G, const Eigen::Vector3d& along);

// Stress (11, 22, 12) in the basis of a lamina to (xx, yy, zz, xy, yz, zx).
Eigen::Matrix<double, 6, 3> stress_to_global(const Eigen::Matrix3d& basis);

// Adds the row of a . (sum f_i u_i) over the nodal displacements.
template <class Row, int N>
void add_translation(Row& row, const Eigen::Vector3d& a, const Eigen::Matrix<double, N, 1>& f) {
  for (int i = 0; i < N; ++i) row.template segment<3>(6 * i) += f[i] * a.transpose();
}

// Adds the row of a . (sum f_i theta_i x V_i) = sum f_i theta_i . (V_i x a).
template <class Row, int N>
void add_director(Row& row, const Eigen::Vector3d& a, const Eigen::Matrix<double, N, 1>& f,
                  const Eigen::Matrix<double, 3, N>& directors) {
  for (int i = 0; i < N; ++i)
    row.template segment<3>(6 * i + 3) +=
        f[i] * Eigen::Vector3d(directors.col(i)).cross(a).transpose();
}

// Rotation of the membrane about its normal, (e2.u,1 - e1.u,2)/2, minus the nodal rotation about
// it.
template <int N>
Eigen::Matrix<double, 1, 6 * N> drilling_row(const Eigen::Vector3d& x_r, const Eigen::Vector3d& x_s,
                                             const Eigen::Matrix<double, N, 1>& shape,
                                             const Eigen::Matrix<double, N, 1>& dr,
                                             const Eigen::Matrix<double, N, 1>& ds) {
  const Eigen::Vector3d normal = x_r.cross(x_s).normalized();
  const Eigen::Vector3d e1 = x_r.normalized(), e2 = normal.cross(e1);
  const Eigen::Vector3d dual_r = x_s.cross(normal) / x_r.cross(x_s).norm();
  const Eigen::Vector3d dual_s = normal.cross(x_r) / x_r.cross(x_s).norm();
  const Eigen::Matrix<double, N, 1> d1 = e1.dot(dual_r) * dr + e1.dot(dual_s) * ds;
  const Eigen::Matrix<double, N, 1> d2 = e2.dot(dual_r) * dr + e2.dot(dual_s) * ds;
  Eigen::Matrix<double, 1, 6 * N> row = Eigen::Matrix<double, 1, 6 * N>::Zero();
  add_translation(row, e2 / 2, d1);
  add_translation(row, -e1 / 2, d2);
  for (int i = 0; i < N; ++i) row.template segment<3>(6 * i + 3) -= shape[i] * normal.transpose();
  return row;
}

} // namespace plica

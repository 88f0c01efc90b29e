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

#include <array>

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

// At a point of the membrane, of its tangents along r and s: right-handed axes, e1 along r, and
// what the shape functions change along e1 and e2.
template <int N> struct MembraneAxes {
  MembraneAxes(const Eigen::Vector3d& x_r, const Eigen::Vector3d& x_s,
               const Eigen::Matrix<double, N, 1>& dr, const Eigen::Matrix<double, N, 1>& ds)
      : normal(x_r.cross(x_s).normalized()), e1(x_r.normalized()), e2(normal.cross(e1)) {
    const Eigen::Vector3d dual_r = x_s.cross(normal) / x_r.cross(x_s).norm();
    const Eigen::Vector3d dual_s = normal.cross(x_r) / x_r.cross(x_s).norm();
    d1 = e1.dot(dual_r) * dr + e1.dot(dual_s) * ds;
    d2 = e2.dot(dual_r) * dr + e2.dot(dual_s) * ds;
  }
  Eigen::Vector3d normal, e1, e2;
  Eigen::Matrix<double, N, 1> d1, d2;
};

// Rotation of the membrane about its normal, (e2.u,1 - e1.u,2)/2, minus the nodal rotation about
// it.
template <int N>
Eigen::Matrix<double, 1, 6 * N> drilling_row(const Eigen::Vector3d& x_r, const Eigen::Vector3d& x_s,
                                             const Eigen::Matrix<double, N, 1>& shape,
                                             const Eigen::Matrix<double, N, 1>& dr,
                                             const Eigen::Matrix<double, N, 1>& ds) {
  const MembraneAxes<N> axes(x_r, x_s, dr, ds);
  Eigen::Matrix<double, 1, 6 * N> row = Eigen::Matrix<double, 1, 6 * N>::Zero();
  add_translation(row, axes.e2 / 2, axes.d1);
  add_translation(row, -axes.e1 / 2, axes.d2);
  for (int i = 0; i < N; ++i)
    row.template segment<3>(6 * i + 3) -= shape[i] * axes.normal.transpose();
  return row;
}

// The same of finite rotation, over increments from the shape now: (t2.x,1 - t1.x,2)/2, the
// tangents t turning with the nodes. Its second variation is left out: the tie carries next to no
// force.
template <int N> struct DrillingTie {
  Eigen::Matrix<double, 1, 6 * N> row;
  double value = 0;
};

template <int N>
DrillingTie<N>
drilling_tie(const Eigen::Matrix<double, 3, N>& rest, const Eigen::Matrix<double, 3, N>& now,
             const std::array<Eigen::Matrix3d, N>& turned, const Eigen::Matrix<double, N, 1>& shape,
             const Eigen::Matrix<double, N, 1>& dr, const Eigen::Matrix<double, N, 1>& ds) {
  const Eigen::Vector3d x_r = rest * dr, x_s = rest * ds;
  const MembraneAxes<N> axes(x_r, x_s, dr, ds);
  const Eigen::Vector3d x_1 = now * axes.d1, x_2 = now * axes.d2;
  Eigen::Vector3d t1 = Eigen::Vector3d::Zero(), t2 = t1;
  for (int i = 0; i < N; ++i) {
    t1 += shape[i] * (turned[i] * axes.e1);
    t2 += shape[i] * (turned[i] * axes.e2);
  }
  DrillingTie<N> tie{Eigen::Matrix<double, 1, 6 * N>::Zero(), (t2.dot(x_1) - t1.dot(x_2)) / 2};
  add_translation(tie.row, t2 / 2, axes.d1);
  add_translation(tie.row, -t1 / 2, axes.d2);
  for (int i = 0; i < N; ++i)
    tie.row.template segment<3>(6 * i + 3) +=
        shape[i] / 2 *
        ((turned[i] * axes.e2).cross(x_1) - (turned[i] * axes.e1).cross(x_2)).transpose();
  return tie;
}

} // namespace plica

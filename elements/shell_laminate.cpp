#include "elements/shell_laminate.hpp"

#include "elements/shell_mitc3_kinematics.hpp"
#include "elements/shell_mitc4_kinematics.hpp"

#include <Eigen/LU>

#include <cmath>

namespace plica {
namespace {

using Eigen::Matrix;
using Eigen::Vector3d;
using Eigen::Vector4d;

// Strain of the mid-surface over the displacements at one point, and the law there.
template <int dofs> struct LaminatePoint {
  double weight = 0; // m2
  Matrix<double, 3, dofs> e, k;
  Matrix<double, 2, dofs> gamma;
  Eigen::Matrix3d A, B, D; // N/m, N, N m
  Eigen::Matrix2d S;       // N/m

  // Work of strains of its own on those of all displacements.
  template <int more>
  Matrix<double, more, dofs> work(const Matrix<double, 3, more>& e2,
                                  const Matrix<double, 3, more>& k2,
                                  const Matrix<double, 2, more>& gamma2) const {
    return weight * (e2.transpose() * (A * e + B * k) + k2.transpose() * (B * e + D * k) +
                     gamma2.transpose() * S * gamma);
  }
  Matrix<double, dofs, dofs> stiffness() const { return work<dofs>(e, k, gamma); }
};

template <int dofs>
LaminatePoint<dofs> laminate_point(const ShellLaminate& wall, const Vector3d& along,
                                   const LaminaFrame& f, double t) {
  const double angle = std::atan2(along.dot(f.basis.col(1)), along.dot(f.basis.col(0)));
  const ShellLaminate here = turned(wall, angle);
  LaminatePoint<dofs> point;
  point.A = t * here.A;
  point.B = t * t * here.B;
  point.D = t * t * t / 12 * here.D;
  point.S = t * here.S;
  return point;
}

} // namespace

Eigen::Matrix3d strain_turn(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Eigen::Matrix3d T;
  T << c * c, s * s, c * s, s * s, c * c, -c * s, -2 * c * s, 2 * c * s, c * c - s * s;
  return T;
}

ShellLaminate turned(const ShellLaminate& wall, double angle) {
  const Eigen::Matrix3d T = strain_turn(angle);
  Eigen::Matrix2d R; // shear along the axes of the wall
  R << std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle);
  ShellLaminate all = wall;
  all.A = T.transpose() * wall.A * T;
  all.B = T.transpose() * wall.B * T;
  all.D = T.transpose() * wall.D * T;
  all.S = R.transpose() * wall.S * R;
  return all;
}

Eigen::Matrix<double, 24, 24> shell_laminate_stiffness(const ShellGeometry& g,
                                                       const ShellLaminate& wall,
                                                       const Vector3d& along,
                                                       MembraneStrain membrane) {
  using namespace mitc4;
  const LaminaFrame centre = centre_frame(g);
  Matrix<double, 24, 24> K = Matrix<double, 24, 24>::Zero();
  Eigen::Matrix4d inner = Eigen::Matrix4d::Zero();
  Matrix4x24 beside = Matrix4x24::Zero();
  for (int i = 0; i < 4; ++i) {
    const double r = gauss_point * corner_r[i], s = gauss_point * corner_s[i];
    const auto n = mitc4::shape_functions(r, s);
    const auto c = covariant_strain(g, membrane, r, s);
    const LaminaFrame f = local_frame(g, membrane, n, 0);
    const double t = g.thickness.dot(n.N);
    auto p = laminate_point<24>(wall, along, f, t);
    p.weight = f.volume;
    p.e = f.in_plane * c.e;
    p.k = f.in_plane * c.k;
    p.gamma = f.shear * c.shear + f.into_shear * c.e;
    K += p.stiffness();
    const Matrix3x4 modes = internal_modes(centre, r, s, f.volume);
    inner += p.weight * modes.transpose() * p.A * modes;
    beside += p.work<4>(modes, Matrix3x4::Zero(), Matrix<double, 2, 4>::Zero());
    const Row drilling = drilling_strain(g, n);
    K += wall.drilling * t * mitc4::area(g, n) * drilling.transpose() * drilling;
  }
  if (membrane == MembraneStrain::incompatible && inner.diagonal().minCoeff() > 0)
    K -= beside.transpose() * inner.inverse() * beside;
  return (K + K.transpose()) / 2;
}

Eigen::Matrix<double, 18, 18> shell_laminate_stiffness(const TriangleGeometry& g,
                                                       const ShellLaminate& wall,
                                                       const Vector3d& along) {
  using namespace mitc3;
  const Kinematics kinematics{g};
  const TiedShear<Row> tied = tied_rows(kinematics);
  Matrix<double, 20, 20> all = Matrix<double, 20, 20>::Zero();
  for (const auto& [r, s, weight] : plane_points) {
    const double t = g.thickness.dot(mitc3::shape_functions(r, s));
    const LaminaFrame f = kinematics.frame(r, s, 0);
    const Matrix3x20 above = kinematics.in_plane(r, s, t), below = kinematics.in_plane(r, s, -t);
    const Matrix3x20 e = kinematics.in_plane(r, s, 0);
    auto p = laminate_point<20>(wall, along, f, t);
    p.weight = weight * f.volume;
    p.e = f.in_plane * e;
    p.k = f.in_plane * (above - below) / (2 * t);
    p.gamma = f.shear * tied_shear(tied, r, s) + f.into_shear * e;
    all += p.stiffness();
  }
  Matrix<double, 18, 18> K = all.topLeftCorner<18, 18>();
  const Eigen::Matrix2d bubble = all.bottomRightCorner<2, 2>();
  if (bubble.diagonal().minCoeff() > 0)
    K -= all.topRightCorner<18, 2>() * bubble.inverse() * all.bottomLeftCorner<2, 18>();
  for (const auto& [r, s, weight] : drilling_points) {
    const Vector3d h = mitc3::shape_functions(r, s);
    const auto drilling = drilling_row<3>(g.X * dr, g.X * ds, h, dr, ds);
    K += weight * twice_area(g) * wall.drilling * g.thickness.dot(h) * drilling.transpose() *
         drilling;
  }
  return (K + K.transpose()) / 2;
}

} // namespace plica

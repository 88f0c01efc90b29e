#include "elements/beam_timoshenko.hpp"

#include "elements/strain_forms.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::RowVector4d;
using Eigen::Vector3d;

// Local displacements of the axis from global nodal ones, and the length.
struct LocalAxis {
  Matrix12 T;
  double length = 0;
};

LocalAxis local_axis(const BeamGeometry& g) {
  const Vector3d axis = g.node2 + g.offset2 - g.node1 - g.offset1;
  const double length = axis.norm();
  if (!(length > 0)) throw std::invalid_argument("a beam of zero length");
  const Vector3d x = axis / length;
  const Vector3d z = g.up - g.up.dot(x) * x;
  if (z.norm() < 1e-6 * g.up.norm())
    throw std::invalid_argument("the up vector of a beam is parallel to its axis");
  Matrix3d R;
  R << x, z.normalized().cross(x), z.normalized();
  LocalAxis local{Matrix12::Zero(), length};
  for (int end = 0; end < 2; ++end) {
    const Vector3d& arm = end == 0 ? g.offset1 : g.offset2;
    local.T.block<3, 3>(6 * end, 6 * end) = R.transpose();
    local.T.block<3, 3>(6 * end, 6 * end + 3) = -R.transpose() * cross_product_matrix(arm);
    local.T.block<3, 3>(6 * end + 3, 6 * end + 3) = R.transpose();
  }
  return local;
}

double shear_parameter(double EI, double GA, double L) {
  return std::isinf(GA) ? 0 : 12 * EI / (GA * L * L);
}

// One plane of bending: local DOFs (v1, slope1, v2, slope2) among the twelve and the sign of the
// rotation that is the slope (v' = +rz in the x-y plane, w' = -ry in the x-z plane).
struct Plane {
  std::array<int, 4> dofs;
  double sign;
};
constexpr Plane plane_xy{{1, 5, 7, 11}, 1}, plane_xz{{2, 4, 8, 10}, -1};

void scatter(Matrix12& K, const Plane& plane, const Matrix4d& k) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      K(plane.dofs[i], plane.dofs[j]) +=
          k(i, j) * (i % 2 ? plane.sign : 1) * (j % 2 ? plane.sign : 1);
}

Matrix4d bending_stiffness(double EI, double phi, double L) {
  Matrix4d k;
  k << 12, 6 * L, -12, 6 * L,                              //
      6 * L, (4 + phi) * L * L, -6 * L, (2 - phi) * L * L, //
      -12, -6 * L, 12, -6 * L,                             //
      6 * L, (2 - phi) * L * L, -6 * L, (4 + phi) * L * L;
  return EI / (L * L * L * (1 + phi)) * k;
}

Matrix4d bending_mass(double mass, double inertia, double phi, double L) {
  constexpr std::array<double, 4> x{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                    0.8611363115940526};
  constexpr std::array<double, 4> w{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                    0.3478548451374538};
  Matrix4d m = Matrix4d::Zero();
  for (int p = 0; p < 4; ++p) {
    const double a = (1 + x[p]) / 2, b = 1 - a, a2 = a * a, a3 = a2 * a;
    const RowVector4d v =
        RowVector4d(1 - 3 * a2 + 2 * a3 + phi * b, L * (a - 2 * a2 + a3 + phi / 2 * a * b),
                    3 * a2 - 2 * a3 + phi * a, L * (a3 - a2 - phi / 2 * a * b)) /
        (1 + phi);
    const RowVector4d slope = RowVector4d(-6 / L * a * b, 1 - 4 * a + 3 * a2 + phi * b,
                                          6 / L * a * b, 3 * a2 - 2 * a + phi * a) /
                              (1 + phi);
    m += w[p] * L / 2 * (mass * v.transpose() * v + inertia * slope.transpose() * slope);
  }
  return m;
}

Matrix12 local_stiffness(const BeamProperties& s, double L) {
  Matrix12 K = Matrix12::Zero();
  for (const auto& [i, k] : {std::pair{0, s.EA / L}, std::pair{3, s.GJ / L}}) {
    K(i, i) = K(i + 6, i + 6) = k;
    K(i, i + 6) = K(i + 6, i) = -k;
  }
  scatter(K, plane_xy, bending_stiffness(s.EI_z, shear_parameter(s.EI_z, s.GA_y, L), L));
  scatter(K, plane_xz, bending_stiffness(s.EI_y, shear_parameter(s.EI_y, s.GA_z, L), L));
  return K;
}

} // namespace

Matrix12 beam_stiffness(const BeamGeometry& g, const BeamProperties& s) {
  const LocalAxis local = local_axis(g);
  return local.T.transpose() * local_stiffness(s, local.length) * local.T;
}

Eigen::Matrix<double, Eigen::Dynamic, 12> beam_end_stress(const BeamGeometry& g,
                                                          const BeamProperties& s) {
  const LocalAxis local = local_axis(g);
  const Matrix12 force = local_stiffness(s, local.length) * local.T; // of the nodes on the beam
  const auto count = static_cast<Eigen::Index>(s.fibres.size());
  Eigen::Matrix<double, Eigen::Dynamic, 12> stress(2 * count, 12);
  for (int end : {0, 1}) {
    const double sign = end == 0 ? -1 : 1; // node 1 holds against what node 2 pulls
    const auto strain = sign / s.EA * force.row(6 * end);
    const auto curvature_y = sign / s.EI_z * force.row(6 * end + 5);  // v''
    const auto curvature_z = -sign / s.EI_y * force.row(6 * end + 4); // w'', w' = -ry
    for (Eigen::Index k = 0; k < count; ++k)
      stress.row(end * count + k) =
          s.E * (strain - s.fibres[k][0] * curvature_y - s.fibres[k][1] * curvature_z);
  }
  return stress;
}

Matrix12 beam_mass(const BeamGeometry& g, const BeamProperties& s) {
  const LocalAxis local = local_axis(g);
  const double L = local.length;
  Matrix12 M = Matrix12::Zero();
  for (const auto& [i, m] : {std::pair{0, s.mass * L / 6}, std::pair{3, s.inertia_x * L / 6}}) {
    M(i, i) = M(i + 6, i + 6) = 2 * m;
    M(i, i + 6) = M(i + 6, i) = m;
  }
  scatter(M, plane_xy, bending_mass(s.mass, s.inertia_z, shear_parameter(s.EI_z, s.GA_y, L), L));
  scatter(M, plane_xz, bending_mass(s.mass, s.inertia_y, shear_parameter(s.EI_y, s.GA_z, L), L));
  return local.T.transpose() * M * local.T;
}

} // namespace plica

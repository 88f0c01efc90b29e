#include "elements/shell_mitc3.hpp"

#include "elements/shell_mitc3_kinematics.hpp"

#include <Eigen/LU>

namespace plica {

using namespace mitc3;

namespace {

std::vector<ShellSample<20>> points_with_bubble(const TriangleGeometry& g,
                                                const ShellSection& section) {
  const Kinematics k{g};
  const TiedShear<Row> tied = tied_rows(k);
  std::vector<ShellSample<20>> points;
  for (const auto& [r, s, weight] : plane_points) {
    const double t = g.thickness.dot(shape_functions(r, s));
    for (double side : {-1., 1.}) {
      const double z = side * std::sqrt(section.bending_factor) * t / 2 / std::sqrt(3.);
      const LaminaFrame f = k.frame(r, s, z);
      const Matrix3x20 e = k.in_plane(r, s, z);
      points.push_back({.r = r,
                        .s = s,
                        .z = z,
                        .weight = weight * f.volume * t / 2,
                        .strain = {.in_plane = f.in_plane * e,
                                   .shear = f.shear * tied_shear(tied, r, s) + f.into_shear * e,
                                   .basis = f.basis,
                                   .volume = f.volume}});
    }
  }
  return points;
}

// The bubble's amplitudes per nodal displacement, from their own equilibrium.
Eigen::Matrix<double, 20, 18> condense(const std::vector<ShellSample<20>>& points,
                                       const ShellLaw& law) {
  Eigen::Matrix<double, 2, 20> K = Eigen::Matrix<double, 2, 20>::Zero();
  for (const ShellSample<20>& p : points)
    K += p.weight *
         (p.strain.in_plane.rightCols<2>().transpose() * law.in_plane * p.strain.in_plane +
          p.strain.shear.rightCols<2>().transpose() * law.shear * p.strain.shear);
  Eigen::Matrix<double, 20, 18> T = Eigen::Matrix<double, 20, 18>::Identity();
  T.bottomRows<2>() = -K.rightCols<2>().inverse() * K.leftCols<18>();
  return T;
}

} // namespace

std::vector<ShellSample<18>> shell_mitc3_points(const TriangleGeometry& g,
                                                const ShellSection& section) {
  const std::vector<ShellSample<20>> points = points_with_bubble(g, section);
  const Eigen::Matrix<double, 20, 18> T = condense(points, shell_law(section));
  std::vector<ShellSample<18>> condensed;
  condensed.reserve(points.size());
  for (const ShellSample<20>& p : points)
    condensed.push_back({p.r,
                         p.s,
                         p.z,
                         p.weight,
                         {.in_plane = p.strain.in_plane * T,
                          .shear = p.strain.shear * T,
                          .basis = p.strain.basis,
                          .volume = p.strain.volume}});
  return condensed;
}

Matrix18 shell_mitc3_stiffness(const TriangleGeometry& g, const ShellSection& section) {
  const ShellLaw law = shell_law(section);
  Matrix18 K = Matrix18::Zero();
  for (const ShellSample<18>& p : shell_mitc3_points(g, section))
    K.noalias() += p.weight * (p.strain.in_plane.transpose() * law.in_plane * p.strain.in_plane +
                               p.strain.shear.transpose() * law.shear * p.strain.shear);
  for (const auto& [r, s, weight] : drilling_points) {
    const Vector3d h = shape_functions(r, s);
    const auto drilling = drilling_row<3>(g.X * dr, g.X * ds, h, dr, ds);
    K.noalias() += weight * twice_area(g) * law.drilling * g.thickness.dot(h) *
                   drilling.transpose() * drilling;
  }
  return (K + K.transpose()) / 2;
}

Matrix18 shell_mitc3_mass(const TriangleGeometry& g, const ShellSection& section) {
  Matrix18 M = Matrix18::Zero();
  for (const auto& [r, s, weight] : plane_points) {
    const Vector3d h = shape_functions(r, s);
    const double t = g.thickness.dot(h);
    Eigen::Matrix<double, 3, 18> u = Eigen::Matrix<double, 3, 18>::Zero(), w = u;
    for (int i = 0; i < 3; ++i) {
      u.block<3, 3>(0, 6 * i) = h[i] * Matrix3d::Identity();
      const Vector3d V = h[i] * g.directors.col(i);
      w.block<3, 3>(0, 6 * i + 3) << 0, V.z(), -V.y(), -V.z(), 0, V.x(), V.y(), -V.x(), 0;
    }
    M.noalias() += section.rho * weight * twice_area(g) *
                   (t * u.transpose() * u + t * t * t / 12 * w.transpose() * w);
  }
  return M;
}

Eigen::Matrix<double, 36, 18> shell_mitc3_face_stress(const TriangleGeometry& g,
                                                      const ShellSection& section) {
  const Kinematics k{g};
  const ShellLaw law = shell_law(section);
  const Eigen::Matrix<double, 20, 18> T = condense(points_with_bubble(g, section), law);
  const double fibre = std::sqrt(section.bending_factor) / 2; // of one ply
  Eigen::Matrix<double, 36, 18> stress;
  for (int corner = 0; corner < 3; ++corner) {
    const double r = corner == 1, s = corner == 2;
    for (int face : {0, 1}) {
      const double z = (face == 0 ? -fibre : fibre) * g.thickness[corner];
      const LaminaFrame f = k.frame(r, s, z);
      stress.middleRows<6>(12 * corner + 6 * face) =
          stress_to_global(f.basis) * law.in_plane * f.in_plane * k.in_plane(r, s, z) * T;
    }
  }
  return stress;
}

} // namespace plica

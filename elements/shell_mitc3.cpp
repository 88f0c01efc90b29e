#include "elements/shell_mitc3.hpp"

#include <Eigen/LU>

#include <array>
#include <cmath>

namespace plica {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Row = Eigen::Matrix<double, 1, 20>; // nodal displacements, then the two bubble amplitudes
using Matrix3x20 = Eigen::Matrix<double, 3, 20>;

const Vector3d dr{-1, 1, 0}, ds{-1, 0, 1}; // of the shape functions

Vector3d shape_functions(double r, double s) {
  return {1 - r - s, r, s};
}

// f_4 and its derivatives along r and s.
struct Bubble {
  double f, r, s;
};
Bubble bubble(double r, double s) {
  return {27 * r * s * (1 - r - s), 27 * s * (1 - 2 * r - s), 27 * r * (1 - r - 2 * s)};
}

// Two unit vectors across the mean director, along which the bubble moves.
Eigen::Matrix<double, 3, 2> bubble_axes(const TriangleGeometry& g) {
  const Vector3d V = g.directors.rowwise().sum().normalized();
  const Vector3d edge = g.X.col(1) - g.X.col(0);
  const Vector3d t = (edge - edge.dot(V) * V).normalized();
  Eigen::Matrix<double, 3, 2> axes;
  axes << t, V.cross(t);
  return axes;
}

struct Kinematics {
  const TriangleGeometry& g;
  Vector3d x_r = g.X * dr, x_s = g.X * ds;                 // mid-surface
  Vector3d V_r = g.directors * dr, V_s = g.directors * ds; // change of the director
  Eigen::Matrix<double, 3, 2> axes = bubble_axes(g);

  // Displacement-based covariant transverse shear 2 e_rz or 2 e_sz.
  Row shear(double r, double s, bool along_r) const {
    const Vector3d h = shape_functions(r, s);
    const Vector3d& x = along_r ? x_r : x_s;
    Row row = Row::Zero();
    add_translation(row, g.directors * h, along_r ? dr : ds);
    add_director(row, x, h, g.directors);
    row.tail<2>() += bubble(r, s).f * x.transpose() * axes;
    return row;
  }

  // In-plane covariant strains (rr, ss, 2rs) at z: e + z k + z^2 q.
  Matrix3x20 in_plane(double r, double s, double z) const {
    const Bubble b = bubble(r, s);
    const Vector3d g_r = x_r + z * V_r, g_s = x_s + z * V_s;
    Row rr = Row::Zero(), ss = Row::Zero(), rs = Row::Zero();
    const auto add = [&](Row& row, const Vector3d& along, const Vector3d& d, double d_bubble) {
      add_translation(row, along, d);
      add_director(row, z * along, d, g.directors);
      row.tail<2>() += z * d_bubble * along.transpose() * axes;
    };
    add(rr, g_r, dr, b.r);
    add(ss, g_s, ds, b.s);
    add(rs, g_r, ds, b.s);
    add(rs, g_s, dr, b.r);
    Matrix3x20 e;
    e << rr, ss, rs;
    return e;
  }

  LaminaFrame frame(double r, double s, double z) const {
    Matrix3d G;
    G << x_r + z * V_r, x_s + z * V_s, g.directors * shape_functions(r, s);
    LaminaFrame f = lamina_frame(G, x_r);
    f.volume /= G.col(2).norm(); // keeps its thickness
    return f;
  }
};

// Tied transverse shear, a linear field of r and s.
struct TiedShear {
  Row centre_r, centre_s, twist;

  explicit TiedShear(const Kinematics& k) {
    constexpr double d = 1e-4;
    const auto rz = [&](double r, double s) { return k.shear(r, s, true); };
    const auto sz = [&](double r, double s) { return k.shear(r, s, false); };
    const Row both = rz(1. / 6, 1. / 6) + sz(1. / 6, 1. / 6); // point C; A and B the other two
    centre_r = 2. / 3 * (rz(2. / 3, 1. / 6) - sz(2. / 3, 1. / 6) / 2) + both / 3;
    centre_s = 2. / 3 * (sz(1. / 6, 2. / 3) - rz(1. / 6, 2. / 3) / 2) + both / 3;
    twist = rz(1. / 3 + d, 1. / 3 + d) - rz(1. / 3 + d, 1. / 3 - 2 * d) -
            sz(1. / 3 + d, 1. / 3 + d) + sz(1. / 3 - 2 * d, 1. / 3 + d);
  }

  Eigen::Matrix<double, 2, 20> at(double r, double s) const {
    Eigen::Matrix<double, 2, 20> shear;
    shear << centre_r + (3 * s - 1) / 3 * twist, centre_s + (1 - 3 * r) / 3 * twist;
    return shear;
  }
};

struct PlanePoint {
  double r, s, weight;
};
constexpr double inner = 0.445948490915965, outer = 0.091576213509771;
constexpr double inner_weight = 0.223381589678011 / 2, outer_weight = 0.109951743655322 / 2;
constexpr std::array<PlanePoint, 6> plane_points{{{inner, inner, inner_weight},
                                                  {1 - 2 * inner, inner, inner_weight},
                                                  {inner, 1 - 2 * inner, inner_weight},
                                                  {outer, outer, outer_weight},
                                                  {1 - 2 * outer, outer, outer_weight},
                                                  {outer, 1 - 2 * outer, outer_weight}}};
// Exact to the second degree.
constexpr std::array<PlanePoint, 3> drilling_points{
    {{1. / 6, 1. / 6, 1. / 6}, {2. / 3, 1. / 6, 1. / 6}, {1. / 6, 2. / 3, 1. / 6}}};

std::vector<ShellSample<20>> points_with_bubble(const TriangleGeometry& g,
                                                const ShellSection& section) {
  const Kinematics k{g};
  const TiedShear tied(k);
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
                                   .shear = f.shear * tied.at(r, s) + f.into_shear * e,
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

double twice_area(const TriangleGeometry& g) {
  return (g.X * dr).cross(g.X * ds).norm();
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

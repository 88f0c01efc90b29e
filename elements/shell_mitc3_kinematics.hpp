// Kinematics of MITC3+, as elements/shell_mitc3.hpp describes them: shared by the element at rest
// and the element at a state (elements/shell_mitc3_state.hpp).
#pragma once

#include "elements/shell_geometry.hpp"
#include "elements/shell_lamina.hpp"

#include <array>
#include <cmath>

namespace plica::mitc3 {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Row = Eigen::Matrix<double, 1, 20>; // nodal displacements, then the two bubble amplitudes
using Matrix3x20 = Eigen::Matrix<double, 3, 20>;

inline const Vector3d dr{-1, 1, 0}, ds{-1, 0, 1}; // of the shape functions

inline Vector3d shape_functions(double r, double s) {
  return {1 - r - s, r, s};
}

// f_4 and its derivatives along r and s.
struct Bubble {
  double f, r, s;
};
inline Bubble bubble(double r, double s) {
  return {27 * r * s * (1 - r - s), 27 * s * (1 - 2 * r - s), 27 * r * (1 - r - 2 * s)};
}

// Two unit vectors across the mean director, along which the bubble moves.
inline Eigen::Matrix<double, 3, 2> bubble_axes(const TriangleGeometry& g) {
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

// Tied transverse shear, a linear field of r and s. T: what has a value for every covariant shear,
// a row over the displacements or a strain.
template <class T> struct TiedShear {
  T centre_r, centre_s, twist;

  // shear(r, s, along_r): displacement-based 2 e_rz or 2 e_sz.
  template <class F> explicit TiedShear(const F& shear) {
    constexpr double d = 1e-4;
    const auto rz = [&](double r, double s) -> T { return shear(r, s, true); };
    const auto sz = [&](double r, double s) -> T { return shear(r, s, false); };
    const T both = rz(1. / 6, 1. / 6) + sz(1. / 6, 1. / 6); // point C; A and B the other two
    centre_r = 2. / 3 * (rz(2. / 3, 1. / 6) - sz(2. / 3, 1. / 6) / 2) + both / 3;
    centre_s = 2. / 3 * (sz(1. / 6, 2. / 3) - rz(1. / 6, 2. / 3) / 2) + both / 3;
    twist = rz(1. / 3 + d, 1. / 3 + d) - rz(1. / 3 + d, 1. / 3 - 2 * d) -
            sz(1. / 3 + d, 1. / 3 + d) + sz(1. / 3 - 2 * d, 1. / 3 + d);
  }

  T rz(double s) const { return centre_r + (3 * s - 1) / 3 * twist; }
  T sz(double r) const { return centre_s + (1 - 3 * r) / 3 * twist; }
};

inline TiedShear<Row> tied_rows(const Kinematics& k) {
  return TiedShear<Row>([&](double r, double s, bool along_r) { return k.shear(r, s, along_r); });
}

inline Eigen::Matrix<double, 2, 20> tied_shear(const TiedShear<Row>& tied, double r, double s) {
  Eigen::Matrix<double, 2, 20> shear;
  shear << tied.rz(s), tied.sz(r);
  return shear;
}

struct PlanePoint {
  double r, s, weight;
};
inline constexpr double inner = 0.445948490915965, outer = 0.091576213509771;
inline constexpr double inner_weight = 0.223381589678011 / 2, outer_weight = 0.109951743655322 / 2;
inline constexpr std::array<PlanePoint, 6> plane_points{{{inner, inner, inner_weight},
                                                         {1 - 2 * inner, inner, inner_weight},
                                                         {inner, 1 - 2 * inner, inner_weight},
                                                         {outer, outer, outer_weight},
                                                         {1 - 2 * outer, outer, outer_weight},
                                                         {outer, 1 - 2 * outer, outer_weight}}};
// Exact to the second degree.
inline constexpr std::array<PlanePoint, 3> drilling_points{
    {{1. / 6, 1. / 6, 1. / 6}, {2. / 3, 1. / 6, 1. / 6}, {1. / 6, 2. / 3, 1. / 6}}};

inline double twice_area(const TriangleGeometry& g) {
  return (g.X * dr).cross(g.X * ds).norm();
}

} // namespace plica::mitc3

// Strains of finite displacement and rotation, as sums of products of vectors that an element
// carries with its nodes:
//
//   eps = a . b - its value at rest,   a = sum a_p y_p,   b = sum b_p y_p
//
// y_p is the place of a node or a vector that turns with it. Increments u of the places and theta
// of the rotations, R -> exp(theta) R, give dy = u or theta x y and, for a vector that turns, the
// second variation theta x (theta x y). The stress s of every strain then adds to the stiffness
//
//   sum_pq H_pq dy_p . dy_q + sum_pq H_pq y_q . d2y_p,   H = sum over strains of s (a b' + b a') /
//   2
//
// (the geometric stiffness), symmetric by construction.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace plica {

// The node of a vector, and whether it turns with that node or is its place.
struct CarriedBy {
  int node = 0;
  bool turns = false;
};

inline Eigen::Matrix3d cross_product_matrix(const Eigen::Vector3d& a) {
  Eigen::Matrix3d A;
  A << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return A;
}

// Adds the geometric stiffness to K, six DOFs a node. H: vectors x vectors, symmetric; Y: 3 x
// vectors; carried: of each vector, a node below 0 does not move.
template <class Forms, class Vectors, class Carried, class Stiffness>
void add_geometric_stiffness(const Forms& H, const Vectors& Y, const Carried& carried,
                             Stiffness& K) {
  const auto count = static_cast<int>(carried.size());
  const auto first = [&](int p) { return 6 * carried[p].node + (carried[p].turns ? 3 : 0); };
  for (int p = 0; p < count; ++p) {
    if (carried[p].node < 0) continue;
    const Eigen::Vector3d y = Y.col(p);
    const Eigen::Matrix3d turn = cross_product_matrix(y);
    for (int q = 0; q < count; ++q) {
      if (carried[q].node < 0 || H(p, q) == 0) continue;
      auto block = K.template block<3, 3>(first(p), first(q));
      if (!carried[p].turns && !carried[q].turns)
        block.diagonal().array() += H(p, q);
      else if (!carried[p].turns) // dy_q = -[y_q]x theta
        block -= H(p, q) * cross_product_matrix(Y.col(q));
      else if (!carried[q].turns) // [y_p]x u
        block += H(p, q) * turn;
      else
        block -= H(p, q) * turn * cross_product_matrix(Y.col(q));
    }
    if (!carried[p].turns) continue;
    const Eigen::Vector3d f = Y * H.col(p);
    auto own = K.template block<3, 3>(first(p), first(p));
    own += (f * y.transpose() + y * f.transpose()) / 2;
    own.diagonal().array() -= f.dot(y);
  }
}

// The wall grows across as it does along: directors of a shape now, longer by the thermal strain.
template <class Geometry> Geometry with_grown_wall(Geometry now, double thermal_strain) {
  now.directors *= 1 + thermal_strain;
  return now;
}

} // namespace plica

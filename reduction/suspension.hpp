// Modes of a reduced structure, also of one that is free or hangs so softly that its rigid motions
// are no modes of its own.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace plica {

constexpr int rigid_modes = 6;
constexpr double small_shift = 0.01; // in terms of the lowest mode

// What holds a structure too little to speak of, over the coordinates at hand.
struct Suspension {
  bool leaves_rigid = false;         // rigid motions are left out of the modes
  double shift = 0;                  // on lambda, so that the stiffness is regular
  Eigen::MatrixXd rigid, rigid_mass; // V' M R and R' M R, R: rigid motions that are loose

  // Of modes of unit mass (columns): share of rigid motion in each, by mass.
  Eigen::VectorXd rigid_shares(const Eigen::MatrixXd& q) const;
};

struct ReducedModes {
  Eigen::VectorXd lambda; // increasing
  Eigen::MatrixXd q;      // of unit mass
};

// The lowest `most` finite pairs of K q = lambda M q by M q = theta (K + shift M) q, less the rigid
// motions among them. None: the structure is not stable.
std::optional<ReducedModes> reduced_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& M,
                                          const Suspension& suspension, Eigen::Index most);

} // namespace plica

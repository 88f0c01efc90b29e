// The matrices of a reduced structure as they follow the coefficients of its changes.
#pragma once

#include "reduction/matrix_difference.hpp"
#include "reduction/suspension.hpp"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace plica {

// A motion that a spring, a mass or a resonator acts on.
struct MotionSum {
  MotionTerm::Of of;
  Eigen::Index first = 0;       // of its terms, among the changes
  Eigen::MatrixXd rows;         // a term each, over q
  Eigen::MatrixXd rigid;        // a term each: by translations along x y z
  Eigen::Index coordinate = -1; // of a resonator: its own in q, sqrt(mass) times its motion
  Eigen::VectorXd coefficients_of(const Eigen::VectorXd& all) const;
  Eigen::VectorXd over_q(const Eigen::VectorXd& all) const;
  double frequency(const Eigen::VectorXd& all) const; // of a resonator, rad/s; 0 = there is none
};

// Matrices over q; the first 6 coordinates of each boundary node are its DOFs. The functions take
// the coefficients of all changes that are no products.
struct AffineModel {
  Eigen::MatrixXd stiffness(const Eigen::VectorXd& coefficients) const;
  Eigen::MatrixXd mass_matrix(const Eigen::VectorXd& coefficients) const;
  Eigen::MatrixXd loads(const Eigen::VectorXd& coefficients) const; // as `load`
  double weight(const Eigen::VectorXd& coefficients) const;         // kg
  // Of what changes by one more of change `group`.
  Eigen::MatrixXd stiffness_of(int group, const Eigen::VectorXd& coefficients) const;
  // These coordinates alone. What a change leaves as it is becomes empty.
  AffineModel restricted_to(const std::vector<int>& coordinates) const;
  // Gives each resonator a coordinate of its own, behind all others. While there is none it moves
  // by itself, far above the nominal modes.
  void hang_resonators();

  Eigen::MatrixXd K, M;
  std::vector<Eigen::MatrixXd> dK, dM;      // per change, products last; empty = none
  std::vector<std::array<int, 2>> products; // their factors
  Eigen::MatrixXd load;                     // V' M r, r: translations along x y z
  std::vector<Eigen::MatrixXd> d_load;
  double mass = 0; // of the whole, held or not, kg
  std::vector<double> d_mass;
  int weighed_along = 0; // the axis of d_mass, which has no part of what sits on held DOFs
  std::vector<MotionSum> sums;
  Eigen::MatrixXd marked;  // 6 rows per marked node, then per observed one: its motion
  Eigen::VectorXd lambda;  // of the nominal modes
  Eigen::MatrixXd nominal; // their coordinates, M-orthonormal
  int boundary = 0;        // coordinates of boundary nodes
  Suspension suspension;   // over q
};

// Coefficients of all changes from those of the ones that are no products.
Eigen::VectorXd with_products(Eigen::VectorXd coefficients,
                              const std::vector<std::array<int, 2>>& products);

} // namespace plica

// Modes of a reduced model under change, with what excites and shows them.
#pragma once

#include "reduction/affine_model.hpp"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace plica {

struct AffineModes {
  Eigen::VectorXd lambda, zeta;
  Eigen::MatrixXd gamma;    // modes x 3: by translations of the base
  Eigen::MatrixXd marked;   // 6 rows per sensor x modes
  Eigen::MatrixXd likeness; // nominal modes x modes: M-product
  Eigen::MatrixXd group;    // modes x modes: of the change that was asked for, coefficient one
  double omega(Eigen::Index i) const { return std::sqrt(lambda[i]); }
  double hertz(Eigen::Index i) const;
  int nominal(Eigen::Index i) const; // which nominal mode it shares most with
};

// Ratios of modes by what they share with the nominal ones, whose ratios are `zeta`; their mean
// where they share nothing. `likeness`: nominal modes x modes.
Eigen::VectorXd damping_by_likeness(const Eigen::MatrixXd& likeness, const Eigen::VectorXd& zeta);

// A reduced model with some of its coordinates held.
class FreeAffineModel {
public:
  FreeAffineModel() = default;
  // `zeta`: damping ratios of the nominal modes; a mode has those of the nominal ones it is like.
  FreeAffineModel(const AffineModel& model, const std::vector<int>& free,
                  const Eigen::VectorXd& zeta);

  // At these coefficients of the changes that are no products; none where the structure is not
  // stable. `group`: a change whose stiffness in modes is wanted.
  std::optional<AffineModes> modes(const Eigen::VectorXd& coefficients, int group = -1) const;

  // With the coefficient of the group changed by a little, in the space of the lowest of the modes
  // at hand.
  AffineModes changed(const AffineModes& modes, double more) const;

private:
  AffineModel free_;
  Eigen::MatrixXd momentum_; // M times the nominal modes
  Eigen::VectorXd zeta_;
};

} // namespace plica

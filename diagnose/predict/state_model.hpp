// One state of the specimen, reduced with hypotheses in it.
#pragma once

#include "diagnose/predict/nominal.hpp"
#include "diagnose/predict/slip_group.hpp"

namespace plica {

// The reduced model of a state, all changes of the hypotheses in it.
struct StateModel {
  const NominalState* nominal = nullptr;
  AffineModel whole;                   // as in the static rig, where nothing is held
  std::vector<Eigen::MatrixXd> losses; // over q, of NominalState::losses
  FreeAffineModel free;                // as on the table
  std::vector<int> coordinates;        // that the mount leaves
  mutable SlipTables tables;
};

// The reduced model of a state with these changes; `losses`: what a rig loses, beside it.
AffineModel with_losses(const NominalState& state, const std::vector<PreparedChange>& changes,
                        std::vector<Eigen::MatrixXd>& losses);

} // namespace plica

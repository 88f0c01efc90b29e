#include "diagnose/predict/state_model.hpp"

namespace plica {

AffineModel with_losses(const NominalState& state, const std::vector<PreparedChange>& changes,
                        std::vector<Eigen::MatrixXd>& losses) {
  if (state.losses.empty()) return state.model->with(changes);
  std::vector<PreparedChange> all = changes;
  for (const RigLoss& l : state.losses) all.push_back(l.stiffness);
  AffineModel model = state.model->with(all);
  losses.assign(model.dK.begin() + std::ptrdiff_t(changes.size()), model.dK.end());
  model.dK.resize(changes.size());
  model.dM.resize(changes.size());
  model.d_load.resize(changes.size());
  model.d_mass.resize(changes.size());
  return model;
}

} // namespace plica

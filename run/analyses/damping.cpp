#include "run/analyses/damping.hpp"

#include "solve/modes.hpp"
#include "solve/strain_energy.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <numeric>

namespace plica {
namespace {

double ratio_of(const Damping& damping, int number, double hertz) {
  for (const ModeDamping& m : damping.modes)
    if (m.mode == number) return m.ratio;
  for (const DampingRange& r : damping.ranges)
    if (hertz >= r.band[0] && hertz <= r.band[1]) return r.ratio;
  return damping.modal;
}

} // namespace

ModalDamping modal_damping(const Damping& damping, const Model& model,
                           const Eigen::VectorXd& lambda, const Eigen::MatrixXd& u, int numbered) {
  const auto energy = [&](const std::vector<int>&) { return strain_energy(model, u); }; // of all
  return modal_damping(damping, model, lambda, energy, numbered);
}

ModalDamping
modal_damping(const Damping& damping, const Model& model, const Eigen::VectorXd& lambda,
              const std::function<Eigen::MatrixXd(const std::vector<int>& columns)>& energy,
              int numbered) {
  const Eigen::Index count = lambda.size();
  ModalDamping result{.zeta = Eigen::VectorXd::Zero(count), .eta = Eigen::VectorXd::Zero(count)};
  for (Eigen::Index j = 0; j < count; ++j)
    result.zeta[j] =
        ratio_of(damping, j < numbered ? static_cast<int>(j) + 1 : 0, frequency(lambda[j]));
  if (damping.loss_factors.empty()) return result;
  std::vector<int> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), 0);
  const Eigen::MatrixXd by_component = energy(all);
  for (std::size_t i = 0; i < damping.loss_factors.size(); ++i) {
    const LossFactor& loss = damping.loss_factors[i];
    const auto found = std::find(model.components.begin(), model.components.end(), loss.of);
    if (found == model.components.end())
      throw InputError({{.file = "",
                         .line = 0,
                         .key = "analyses.damping.loss_factors[" + std::to_string(i) + "].of",
                         .wrong = "\"" + loss.of + "\" has no stiffness",
                         .allowed = "a part with stiffness, or mount.<cap> of a spring mount"}});
    const Eigen::RowVectorXd share = by_component.row(found - model.components.begin());
    for (Eigen::Index j = 0; j < count; ++j)
      if (lambda[j] > 0) result.eta[j] += loss.value * share[j] / lambda[j];
  }
  return result;
}

} // namespace plica

#include "run/analyses/dissipation.hpp"

#include "model/description/place_keys.hpp"
#include "run/analyses/damping.hpp"
#include "solve/strain_energy.hpp"

#include <algorithm>
#include <cmath>

namespace plica {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Loads with_dampers(Loads loads, const BuiltCase& built) {
  const auto before = Index(loads.base.size()), count = Index(built.dampers.size());
  if (count == 0) return loads;
  const Index dofs = dof_count(built.model);
  loads.force.conservativeResize(dofs, before + count);
  loads.rigid.conservativeResize(dofs, before + count);
  loads.base.resize(std::size_t(before + count), -1);
  loads.rigid.rightCols(count).setZero();
  for (Index k = 0; k < count; ++k) {
    const BuiltDamper& d = built.dampers[std::size_t(k)];
    loads.force.col(before + k) = unit_force(built.model, d.node1, d.node2, d.dof);
  }
  return loads;
}

AddedStiffness added_by(const BuiltDamper& damper) {
  return [own = damper](std::complex<double> s) {
    return added_stiffness(own.law, own.dof, own.stiffness, s);
  };
}

Dissipation dissipation(const Damping& damping, const BuiltCase& built,
                        const ModalSolution& solution, const Excitations* excited) {
  Dissipation d;
  const auto first = int(solution.input.cols()) - int(built.dampers.size());
  for (std::size_t k = 0; k < built.dampers.size(); ++k)
    d.springs.push_back({.column = first + int(k), .added = added_by(built.dampers[k])});
  const Index columns = solution.u.cols(), loads = solution.input.cols();
  if (excited && excited->stretch.size() > 0) {
    d.stretch = MatrixXd::Zero(excited->stretch.rows(), loads);
    d.stretch.leftCols(excited->stretch.cols()) = excited->stretch;
  }
  // Loss factors of springs are in the dampers.
  if (!damping.coupled || std::all_of(damping.loss_factors.begin(), damping.loss_factors.end(),
                                      [](const LossFactor& loss) { return is_springs(loss.of); }))
    return d;
  // With the fields of moved ends behind the modes; a rigid motion strains nothing.
  std::vector<Index> moved;
  for (Index k = 0; excited && k < excited->loads.rigid.cols(); ++k)
    if (excited->loads.base[std::size_t(k)] < 0 && !excited->loads.rigid.col(k).isZero(0))
      moved.push_back(k);
  MatrixXd fields(solution.u.rows(), columns + Index(moved.size()));
  fields.leftCols(columns) = solution.u;
  for (std::size_t k = 0; k < moved.size(); ++k)
    fields.col(columns + Index(k)) = excited->loads.rigid.col(moved[k]);
  MatrixXd L = MatrixXd::Zero(fields.cols(), fields.cols());
  const std::vector<MatrixXd> parts = component_stiffness(built.model, fields);
  for (const LossFactor& loss : damping.loss_factors)
    for (std::size_t c = 0; c < parts.size(); ++c)
      if (built.model.components[c] == loss.of && !is_springs(loss.of))
        L += loss.value / 2 * (parts[c] + parts[c].transpose());
  d.loss = L.topLeftCorner(columns, columns);
  d.carried_loss = MatrixXd::Zero(columns, loads);
  for (std::size_t k = 0; k < moved.size(); ++k)
    d.carried_loss.col(moved[k]) = L.col(columns + Index(k)).head(columns);
  return d;
}

VectorXd first_order_damping(const Dissipation& d, const ModalSolution& solution) {
  VectorXd zeta = VectorXd::Zero(solution.lambda.size());
  for (Index j = 0; j < zeta.size(); ++j) {
    if (!(solution.lambda[j] > 0)) continue;
    double loss = d.loss.size() > 0 ? d.loss(j, j) : 0;
    for (const DampedSpring& spring : d.springs)
      loss += std::norm(solution.input(j, spring.column)) *
              spring.added({0, std::sqrt(solution.lambda[j])}).imag();
    zeta[j] = loss / (2 * solution.lambda[j]);
  }
  return zeta;
}

} // namespace plica

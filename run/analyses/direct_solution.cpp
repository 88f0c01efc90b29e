#include "run/analyses/direct_solution.hpp"

#include "model/description/place_keys.hpp"
#include "run/analyses/damping.hpp"
#include "run/analyses/dissipation.hpp"
#include "solve/base_motion.hpp"
#include "solve/statics.hpp"

#include <numbers>

namespace plica {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

DirectSolution::DirectSolution(const DirectProblem& problem)
    : built_(problem.built), excited_(problem.excited), system_(assemble(problem.built.model)),
      free_(complement(system_.map.size(), node_dofs(system_.map, problem.built.held_nodes))) {
  model_.K = restrict_to(system_.K, free_);
  model_.M = restrict_to(system_.M, free_);
  if (problem.damping.coupled) add_loss(problem.damping);
  model_.springs = MatrixXd::Zero(Index(free_.size()), Index(built_.dampers.size()));
  for (std::size_t k = 0; k < built_.dampers.size(); ++k) {
    const BuiltDamper& d = built_.dampers[k];
    model_.springs.col(Index(k)) = on_free(unit_force(built_.model, d.node1, d.node2, d.dof));
    model_.added.push_back(added_by(d));
  }
  add_modal_damping(problem.modes);
  add_forces();
}

MatrixXcd DirectSolution::acceleration(double hertz) const {
  const double omega = 2 * std::numbers::pi * hertz;
  const auto count = Index(excited_.list.size());
  MatrixXcd force = MatrixXcd::Zero(force_.rows(), count);
  MatrixXcd carried = MatrixXcd::Zero(dof_count(built_.model), count);
  for (Index e = 0; e < count; ++e)
    for (const ExcitedColumn& part : excited_.list[std::size_t(e)].parts) {
      force.col(e) += part.factor * load(part.column, omega);
      carried.col(e) += part.factor * excited_.loads.rigid.col(part.column);
    }
  const MatrixXcd u = direct_response(model_, force, omega);
  MatrixXd q = MatrixXd::Zero(system_.map.size(), 2 * count);
  q(free_, Eigen::seqN(0, count)) = u.real();
  q(free_, Eigen::seqN(count, count)) = u.imag();
  const MatrixXd seen = at_sensors(built_, expand(system_.map, q));
  const MatrixXd base = at_sensors(built_, carried.real()),
                 ahead = at_sensors(built_, carried.imag());
  MatrixXcd a(seen.rows(), count);
  a.real() = base - omega * omega * seen.leftCols(count);
  a.imag() = ahead - omega * omega * seen.rightCols(count);
  return a.transpose();
}

VectorXd DirectSolution::on_free(const VectorXd& all) const {
  return gather(system_.map, all)(free_);
}

void DirectSolution::add_loss(const Damping& damping) {
  VectorXd eta = VectorXd::Zero(Index(built_.model.components.size()));
  for (const LossFactor& loss : damping.loss_factors)
    for (Index c = 0; c < eta.size(); ++c)
      if (built_.model.components[std::size_t(c)] == loss.of && !is_springs(loss.of))
        eta[c] += loss.value;
  if (eta.isZero(0)) return;
  loss_ = loss_matrix(built_.model, system_.map, eta);
  model_.loss = restrict_to(loss_, free_);
}

// What is stated as a fraction of critical or as a loss factor of every mode by itself.
void DirectSolution::add_modal_damping(const DampedModes& modes) {
  const ModalSolution& s = modes.solution;
  std::vector<int> damped, rows;
  for (Index j = 0; j < s.lambda.size(); ++j)
    if (modes.zeta[j] != 0 || modes.eta[j] != 0) damped.push_back(int(j));
  for (const int dof : free_) rows.push_back(system_.map.full[std::size_t(dof)]);
  model_.shapes = symmetric_product(model_.M, s.u(rows, damped));
  model_.lambda = s.lambda(damped);
  model_.zeta = modes.zeta(damped);
  model_.eta = modes.eta(damped);
}

void DirectSolution::add_forces() {
  const Loads& loads = excited_.loads;
  const auto count = Index(loads.base.size());
  const BaseMotion base = base_motion(built_.model, system_, free_, {0, 0, 0});
  force_.resize(Index(free_.size()), count);
  for (Index k = 0; k < count; ++k) {
    const int direction = loads.base[std::size_t(k)];
    force_.col(k) =
        direction >= 0 ? VectorXd(base.force.col(direction)) : on_free(loads.force.col(k));
  }
}

// With what is lost in the strain that ends carry along.
VectorXcd DirectSolution::load(int column, double omega) const {
  VectorXcd f = force_.col(column).cast<Complex>();
  if (excited_.loads.base[std::size_t(column)] >= 0) return f;
  const double over = 1 / (omega * omega);
  if (loss_.size() > 0) {
    VectorXd carried(system_.map.size());
    for (Index i = 0; i < carried.size(); ++i)
      carried[i] = excited_.loads.rigid(system_.map.full[std::size_t(i)], column);
    f += Complex(0, over) * symmetric_product(loss_, carried)(free_, 0);
  }
  for (Index k = 0; k < model_.springs.cols(); ++k)
    if (const double stretch = excited_.stretch(k, column); stretch != 0)
      f += over * stretch * model_.added[std::size_t(k)]({0, omega}) * model_.springs.col(k);
  return f;
}

std::vector<MatrixXcd> solve_directly(const DirectProblem& problem,
                                      const std::vector<double>& hertz) {
  const DirectSolution direct(problem);
  std::vector<MatrixXcd> answers;
  for (const double at : hertz) answers.push_back(direct.acceleration(at));
  return answers;
}

} // namespace plica

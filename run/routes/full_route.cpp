#include "model/shape/constraint_clash.hpp"
#include "run/routes/route.hpp"
#include "run/stages.hpp"
#include "solve/base_motion.hpp"
#include "solve/effective_mass.hpp"
#include "solve/mode_labels.hpp"
#include "solve/model_error.hpp"
#include "solve/static_correction.hpp"
#include "solve/stopwatch.hpp"
#include "solve/supports.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::MatrixXd;

System assemble_case(const BuiltCase& built) {
  try {
    return assemble(built.model);
  } catch (const ConstraintError& error) {
    refuse_clash(error);
  } catch (const std::invalid_argument& error) {
    input_error("", error.what(), "");
  }
}

class FullRoute : public Route {
public:
  FullRoute(const BuiltCase& built, std::string reason, const StageListener& stage, Timing& timing)
      : built_(built), reason_(std::move(reason)), stage_(stage), timing_(timing) {
    stage_(stages::assembly);
    system_ = assemble_case(built_);
    held_ = node_dofs(system_.map, built_.held_nodes);
    free_ = complement(system_.map.size(), held_);
    K_ = restrict_to(system_.K, free_);
    M_ = restrict_to(system_.M, free_);
    watch_.lap(timing_, "assembly");
  }

  std::string name() const override { return "full mesh: " + reason_; }
  int unknowns() const override { return system_.map.size(); }
  double mass() const override {
    // What supports hold is no unknown. Superelements hold scalar coordinates, not nodes.
    if (has_supports(built_.model) && built_.model.scalar_nodes.empty())
      return total_mass(built_.model);
    const std::vector<int> all = complement(system_.map.size(), {});
    return free_mass(built_.model, system_.map, all, system_.M).mass;
  }

  std::optional<Matrix1212> end_stiffness(const std::array<int, 2>& caps) override {
    solved_caps_.reset();
    own_.reset();
    boundary_ = node_dofs(system_.map, {caps[0], caps[1]});
    if (boundary_.size() != 12) return std::nullopt;
    // The rig holds both caps; with another mount the stiffness is that of the part alone.
    const bool shared = boundary_ == held_ && base().sigma == 0;
    stage_(stages::statics);
    leave_the_mount_away();
    if (!shared) {
      const SparseMatrix inner = restrict_to(part(), complement(system_.map.size(), boundary_));
      own_.emplace(inner);
      if (!own_->factorise(inner).ok)
        throw ModelError("static stiffness: the part is a mechanism when both caps are held");
    }
    const MatrixXd condensed = condense(part(), boundary_, inner());
    watch_.lap(timing_, "statics");
    solved_caps_ = caps;
    const auto order = order_of(caps);
    return Matrix1212(condensed(order, order));
  }

  MatrixXd follow(const std::array<int, 2>& caps, const MatrixXd& motion) override {
    if (solved_caps_ != caps && !end_stiffness(caps))
      throw std::logic_error("a support holds one of the caps that are to move");
    const auto order = order_of(caps);
    MatrixXd at_boundary(12, motion.cols());
    at_boundary(order, Eigen::all) = motion;
    return expand(system_.map, follow_boundary(part(), boundary_, inner(), at_boundary));
  }

  ModalSolution modes(const ModesRequest& request, const Loads& loads,
                      const std::vector<int>& sensors) override {
    BaseFactor& factor = base();
    stage_(stages::modes);
    ModalSolution solution;
    solution.free_body = factor.sigma < 0;
    solution.with_mass = dofs_with_mass(M_);
    const MatrixXd force = loads_on_free(loads);
    MatrixXd static_solutions(K_.rows(), 0);
    if (force.cols() > 0) {
      require_held(solution.free_body, built_);
      static_solutions = factor.factor.solve(force);
    }
    ModeSet set = find_modes(K_, M_, request, factor);
    base_.reset(); // overwritten by the proof
    solution.timing = set.timing;
    watch_ = Stopwatch();
    MatrixXd u = expand_free(set.Phi);
    orient_modes(built_.model, sensors, set.lambda, set.Phi, u);
    const ModalBasis basis = add_static_correction(K_, M_, set.lambda, set.Phi, static_solutions);
    const Eigen::Index pseudo = basis.lambda.size() - set.lambda.size();
    solution.lambda = basis.lambda;
    solution.modes = basis.modes;
    solution.u.resize(u.rows(), u.cols() + pseudo);
    solution.u << u, expand_free(basis.Phi.rightCols(pseudo));
    solution.input = basis.Phi.transpose() * force;
    solution.residual = set.residual;
    solution.rounding = set.rounding;
    solution.proof = set.proof;
    const FreeMass free = free_mass(built_.model, system_.map, free_, M_);
    solution.participation = set.Phi.transpose() * symmetric_product(M_, free.R);
    solution.mass = free.mass;
    solution.free_mass = free.total;
    return solution;
  }

private:
  BaseFactor& base() {
    if (!base_) {
      stage_(stages::factorisation);
      base_.emplace(factor_below_spectrum(K_, M_));
      watch_.lap(timing_, "factorisation");
    }
    return *base_;
  }

  // A spring mount is not the part. Assembled anew: subtracted, a stiff one would leave its
  // rounding in place of the part. Without one, no second matrix is kept.
  void leave_the_mount_away() {
    if (without_mount_) return;
    Model part = built_.model;
    if (std::erase_if(part.bushings, [](const BushingElement& b) { return b.node2 < 0; }) > 0)
      without_mount_ = assemble(part).K;
  }
  const SparseMatrix& part() const { return without_mount_ ? *without_mount_ : system_.K; }

  const SparseFactor& inner() { return own_ ? *own_ : base().factor; }

  // Row of each DOF of the caps, in their order, among the boundary DOFs.
  std::vector<int> order_of(const std::array<int, 2>& caps) const {
    std::vector<int> order;
    for (int node : caps)
      for (int dof = 6 * node; dof < 6 * node + 6; ++dof)
        order.push_back(
            int(std::lower_bound(boundary_.begin(), boundary_.end(), system_.map.independent[dof]) -
                boundary_.begin()));
    return order;
  }

  // Over all DOFs from the free ones.
  MatrixXd expand_free(const MatrixXd& free) const {
    MatrixXd q = MatrixXd::Zero(system_.map.size(), free.cols());
    q(free_, Eigen::all) = free;
    return expand(system_.map, q);
  }

  MatrixXd loads_on_free(const Loads& loads) const {
    MatrixXd force(Eigen::Index(free_.size()), Eigen::Index(loads.base.size()));
    const BaseMotion base = base_motion(built_.model, system_, free_, {0, 0, 0});
    for (Eigen::Index k = 0; k < force.cols(); ++k) {
      if (loads.base[k] >= 0)
        force.col(k) = base.force.col(loads.base[k]);
      else
        force.col(k) = gather(system_.map, loads.force.col(k))(free_);
    }
    return force;
  }

  const BuiltCase& built_;
  std::string reason_;
  const StageListener& stage_;
  Timing& timing_;
  Stopwatch watch_;
  System system_;
  std::vector<int> free_, held_, boundary_; // boundary: of the solved caps
  std::optional<std::array<int, 2>> solved_caps_;
  SparseMatrix K_, M_;
  std::optional<SparseMatrix> without_mount_;
  std::optional<BaseFactor> base_;
  std::optional<SparseFactor> own_;
};

} // namespace

std::vector<int> node_dofs(const DofMap& map, const std::vector<int>& nodes) {
  std::vector<int> dofs;
  for (int node : nodes)
    for (int dof = 6 * node; dof < 6 * node + 6; ++dof)
      if (map.independent[dof] >= 0) dofs.push_back(map.independent[dof]);
  std::sort(dofs.begin(), dofs.end());
  return dofs;
}

std::unique_ptr<Route> full_route(const BuiltCase& built, const std::string& reason,
                                  const StageListener& stage, Timing& timing) {
  return std::make_unique<FullRoute>(built, reason, stage, timing);
}

} // namespace plica

#include "engine/distributed_model.hpp"

#include "engine/memory_of_ranks.hpp"
#include "engine/residual_vectors.hpp"
#include "model/shape/constraint_clash.hpp"
#include "solve/effective_mass.hpp"
#include "solve/mode_labels.hpp"
#include "solve/model_error.hpp"
#include "solve/statics.hpp"
#include "solve/stopwatch.hpp"
#include "solve/supports.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <fmt/core.h>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr int least_unknowns = 200; // for a rank: below, it would do nothing but wait

void require_work(int unknowns, const Ranks& ranks) {
  if (unknowns >= least_unknowns * ranks.size()) return;
  input_error(
      "parts", fmt::format("have {} unknowns, too few for {} ranks", unknowns, ranks.size()),
      unknowns < 2 * least_unknowns ? "plica run: the model is small"
                                    : fmt::format("at most {} ranks here, {} unknowns to each",
                                                  unknowns / least_unknowns, least_unknowns));
}

// The motions of rigid_body_motions(), own independent rows alone.
MatrixXd own_rigid_motions(const Model& model, const DofMap& map, const RowShare& share) {
  DofMap own{.independent = {}, .dependent = {}, .first = {}, .full = {}};
  own.full.assign(map.full.begin() + share.first, map.full.begin() + share.end);
  return rigid_body_motions(model, own, Eigen::Vector3d::Zero());
}

} // namespace

DistributedModel::DistributedModel(const BuiltCase& built, const Ranks& ranks,
                                   MumpsSettings settings,
                                   std::function<void(const std::string&)> log)
    : built_(built), ranks_(ranks), settings_(std::move(settings)), log_(std::move(log)),
      map_(eliminate_constraints(built.model)) {
  settings_.note = log_;
  require_work(map_.size(), ranks);
  require_memory_of_nodes(map_.size(), ranks);
  share_ = share_of(map_, ranks);
  held_ = node_dofs(map_, built.held_nodes);
  free_ = own_without(held_);
  if (ranks.sum((long long)free_.size()) == 0)
    throw ModelError("nothing is free to move: supports and mounts hold it all",
                     {"supports", "mount", "parts"});
  DistributedSystem system;
  try {
    system = assemble_rows(built.model, map_, ranks);
  } catch (const std::invalid_argument& error) {
    input_error("", error.what(), "");
  }
  const MatrixXd r = own_rigid_motions(built.model, map_, share_);
  const MatrixXd Mr = system.M * r;
  rigid_ = r(free_, Eigen::all);
  base_force_ = Mr(free_, Eigen::all);
  mass_ = has_supports(built.model) && built.model.scalar_nodes.empty()
              ? total_mass(built.model)
              : ranks.sum(MatrixXd(r.transpose() * Mr)).topLeftCorner(3, 3).trace() / 3;
  K_ = std::move(system.K);
  std::vector<int> own = free_;
  for (int& row : own) row += share_.first;
  K_free_ = K_.part(own, ranks);
  M_free_ = system.M.part(own, ranks);
  log_(fmt::format("{} unknowns, {} rank{}, {:.3g} entries of the stiffness", map_.size(),
                   ranks.size(), ranks.size() == 1 ? "" : "s", K_.entries(ranks)));
}

std::vector<int> DistributedModel::own_without(const std::vector<int>& held) const {
  std::vector<int> kept;
  for (int dof = share_.first; dof < share_.end; ++dof)
    if (!std::binary_search(held.begin(), held.end(), dof)) kept.push_back(dof - share_.first);
  return kept;
}

void DistributedModel::report(const std::string& of, const MumpsReport& f) const {
  log_(fmt::format("{}: MUMPS, ordering {}, {:.4g} entries, {:.3g} flops, {:.0f} MB on the fullest "
                   "rank, {:.0f} MB on all, {} pivots delayed, workspace {} %{}",
                   of, f.ordering, f.entries, f.flops, f.megabytes, f.megabytes_sum, f.delayed,
                   f.workspace, f.retries > 0 ? fmt::format(", {} retries", f.retries) : ""));
}

void DistributedModel::factor_base() {
  if (base_) return;
  base_.emplace(factor_under_spectrum(K_free_, M_free_, ranks_, settings_));
  report("factor", base_->factor->report());
}

// A spring mount is not the part: assembled anew without it.
DistributedModel::Held& DistributedModel::without_mount(const std::vector<int>& boundary) {
  if (statics_ && solved_ == boundary) return *statics_;
  statics_.emplace();
  Model part = built_.model;
  const bool sprung =
      std::erase_if(part.bushings, [](const BushingElement& b) { return b.node2 < 0; }) > 0;
  if (sprung) statics_->whole = assemble_rows(part, map_, ranks_).K;
  statics_->kept = own_without(boundary);
  const bool shared = boundary == held_ && !sprung;
  if (shared) factor_base();
  if (!shared || base_->sigma != 0) {
    std::vector<int> own = statics_->kept;
    for (int& row : own) row += share_.first;
    statics_->inner = (sprung ? statics_->whole : K_).part(own, ranks_);
    statics_->factor.emplace(statics_->inner, Definiteness::definite, ranks_, settings_);
    report("factor of statics", statics_->factor->report());
    if (statics_->factor->negative_pivots() + statics_->factor->null_pivots() > 0)
      throw ModelError("static stiffness: the part is a mechanism when both caps are held");
  }
  solved_ = boundary;
  return *statics_;
}

MatrixXd DistributedModel::follow_boundary(Held& part, const std::vector<int>& boundary,
                                           const MatrixXd& at_boundary) {
  constexpr int refinements = 2; // as on one machine: with exact residuals each gains six digits
  const DistributedMatrix& K = part.whole.mat() ? part.whole : K_;
  if (!part.factor) factor_base();
  const MumpsFactor& factor = part.factor ? *part.factor : *base_->factor;
  MatrixXd u = MatrixXd::Zero(share_.end - share_.first, at_boundary.cols());
  for (std::size_t b = 0; b < boundary.size(); ++b)
    if (boundary[b] >= share_.first && boundary[b] < share_.end)
      u.row(boundary[b] - share_.first) = at_boundary.row(Index(b));
  for (int step = 0; step <= refinements; ++step) {
    const MatrixXd force = K.exactly(u);
    u(part.kept, Eigen::all) -= factor.solve(force(part.kept, Eigen::all));
  }
  return u;
}

namespace {

// Row of each DOF of the caps, in their order, among the boundary DOFs.
std::vector<int> order_of(const std::array<int, 2>& caps, const std::vector<int>& boundary,
                          const DofMap& map) {
  std::vector<int> order;
  for (const int node : caps)
    for (int dof = 6 * node; dof < 6 * node + 6; ++dof)
      order.push_back(int(
          std::lower_bound(boundary.begin(), boundary.end(), map.independent[std::size_t(dof)]) -
          boundary.begin()));
  return order;
}

} // namespace

std::optional<Matrix1212> DistributedModel::end_stiffness(const std::array<int, 2>& caps) {
  const std::vector<int> boundary = node_dofs(map_, {caps[0], caps[1]});
  if (boundary.size() != 12) return std::nullopt;
  Held& part = without_mount(boundary);
  const MatrixXd u = follow_boundary(part, boundary, MatrixXd::Identity(12, 12));
  const MatrixXd force = (part.whole.mat() ? part.whole : K_).exactly(u);
  MatrixXd reaction = MatrixXd::Zero(12, 12);
  for (std::size_t b = 0; b < boundary.size(); ++b)
    if (boundary[b] >= share_.first && boundary[b] < share_.end)
      reaction.row(Index(b)) = force.row(boundary[b] - share_.first);
  reaction = ranks_.sum(reaction);
  reaction = ((reaction + reaction.transpose()) / 2).eval();
  const std::vector<int> order = order_of(caps, boundary, map_);
  return Matrix1212(reaction(order, order));
}

MatrixXd DistributedModel::follow(const std::array<int, 2>& caps, const MatrixXd& motion) {
  const std::vector<int> boundary = node_dofs(map_, {caps[0], caps[1]});
  if (boundary.size() != 12) throw std::logic_error("a support holds one of the caps to be moved");
  MatrixXd at_boundary(12, motion.cols());
  at_boundary(order_of(caps, boundary, map_), Eigen::all) = motion;
  const MatrixXd q =
      ranks_.gather_rows(follow_boundary(without_mount(boundary), boundary, at_boundary));
  return ranks_.first() ? expand(map_, q) : MatrixXd();
}

MatrixXd DistributedModel::loads_on_free(const EngineLoads& loads) const {
  const auto count = Index(loads.base.size());
  MatrixXd all(ranks_.first() ? map_.size() : 0, count);
  if (ranks_.first())
    for (Index k = 0; k < count; ++k)
      all.col(k) = loads.base[std::size_t(k)] >= 0 ? Eigen::VectorXd::Zero(map_.size())
                                                   : gather(map_, loads.force.col(k));
  MatrixXd force = ranks_.scatter_rows(all, share_.end - share_.first)(free_, Eigen::all);
  for (Index k = 0; k < count; ++k)
    if (const int direction = loads.base[std::size_t(k)]; direction >= 0)
      force.col(k) = -base_force_.col(direction);
  return force;
}

// Over all DOFs, on the first rank.
MatrixXd DistributedModel::expand_free(const MatrixXd& own_free) const {
  const MatrixXd free = ranks_.gather_rows(own_free);
  if (!ranks_.first()) return {};
  MatrixXd q = MatrixXd::Zero(map_.size(), free.cols());
  q(complement(map_.size(), held_), Eigen::all) = free;
  return expand(map_, q);
}

ModalSolution DistributedModel::modes(const ModesRequest& request, const EngineLoads& loads,
                                      const std::vector<int>& sensors) {
  factor_base();
  ModalSolution solution;
  solution.free_body = base_->sigma < 0;
  solution.with_mass = dofs_with_mass(M_free_, ranks_);
  const MatrixXd force = loads_on_free(loads);
  MatrixXd static_solutions(K_free_.own_rows(), 0);
  if (force.cols() > 0) {
    if (solution.free_body)
      input_error("analyses", "ask for a response, but nothing holds the part or a piece of it",
                  "a mount or supports that leave no rigid motion free");
    static_solutions = base_->factor->solve(force);
  }
  DistributedModes found = find_modes(K_free_, M_free_, request, *base_, ranks_, settings_);
  base_.reset();
  if (found.proof.made) report("factor of the proof", found.counted);
  solution.timing = found.timing;
  Stopwatch watch;
  MatrixXd u = expand_free(found.Phi);
  MatrixXd turn = MatrixXd::Identity(found.lambda.size(), found.lambda.size());
  if (ranks_.first()) orient_modes(built_.model, sensors, found.lambda, turn, u);
  found.Phi = (found.Phi * ranks_.broadcast(turn)).eval();
  const DistributedBasis basis =
      with_residual_vectors(K_free_, M_free_, found.lambda, found.Phi, static_solutions, ranks_);
  const MatrixXd pseudo = expand_free(basis.pseudo);
  solution.lambda = basis.lambda;
  solution.modes = int(found.lambda.size());
  solution.u.resize(u.rows(), u.cols() + pseudo.cols());
  if (ranks_.first()) solution.u << u, pseudo;
  solution.input.resize(basis.lambda.size(), force.cols());
  solution.input << ranks_.sum(MatrixXd(found.Phi.transpose() * force)),
      ranks_.sum(MatrixXd(basis.pseudo.transpose() * force));
  solution.residual = found.residual;
  solution.rounding = found.rounding;
  solution.proof = found.proof;
  const MatrixXd MR = M_free_ * rigid_;
  solution.participation = ranks_.sum(MatrixXd(found.Phi.transpose() * MR));
  const CentralMass central =
      refer_to_centre(ranks_.sum(MatrixXd(rigid_.transpose() * MR)), solution.participation);
  solution.mass = central.mass;
  solution.free_mass = central.total;
  watch.lap(solution.timing, "recovery");
  log_(fmt::format("peak memory: {:.0f} MB on the fullest rank, {:.0f} MB on all",
                   ranks_.largest(peak_memory()) / 1e6, ranks_.sum(peak_memory()) / 1e6));
  return solution;
}

} // namespace plica

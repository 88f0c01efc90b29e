#include "run/study/assembly_study.hpp"

#include "model/shape/renewed_ends.hpp"
#include "run/analyses/dynamics.hpp"
#include "run/analyses/static_stiffness.hpp"
#include "run/routes/built_reduced.hpp"
#include "run/stages.hpp"
#include "solve/constraints.hpp"
#include "solve/effective_mass.hpp"
#include "solve/mode_labels.hpp"
#include "solve/supports.hpp"

namespace plica {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

using RowSparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;

bool has_to_run_whole(const Case& data) {
  const Analyses& a = data.analyses;
  return !a.reduction || data.state || has_friction(data) || has_damped_springs(data) ||
         !a.damping.loss_factors.empty() || !data.supports.empty() || a.stress || a.response ||
         a.levels || a.life || !a.transients.empty() || !a.run_ups.empty();
}

// What recovers the watched nodes from the reduced model, a stretch of its coordinates at a time.
RowSparse recovery_of(const ReducedModel& reduced, const std::vector<int>& nodes) {
  const Index all = dof_count(reduced.model);
  constexpr Index stretch = 96;
  std::vector<Eigen::Triplet<double>> entries;
  for (Index first = 0; first < all; first += stretch) {
    const Index count = std::min(stretch, all - first);
    MatrixXd unit = MatrixXd::Zero(all, count);
    unit.middleRows(first, count).setIdentity();
    const MatrixXd u = reduced.field_at(unit, nodes);
    for (Index j = 0; j < count; ++j)
      for (Index i = 0; i < u.rows(); ++i)
        if (u(i, j) != 0) entries.emplace_back(int(i), int(first + j), u(i, j));
  }
  RowSparse recovery(6 * Index(nodes.size()), all);
  recovery.setFromTriplets(entries.begin(), entries.end());
  return recovery;
}

} // namespace

struct AssemblyStudy::Kept {
  Case data;
  ModelSize size; // but for the mass
  Reduced reduced;
  std::string route, not_proved; // the second empty where all reductions are
  BuiltCase frame;               // interface nodes with the superelements between them
  BuiltCase watched;
  RowSparse recovery; // of the watched nodes, from the frame
  // Rigid motions of what the mount does not hold, at the frame, and masses of all but what lies on
  // the frame times them, as forces there; together about the origin.
  MatrixXd rigid, weight;
  Matrix66 about_origin;
};

namespace {

// Solves the frame, and recovers the watched nodes.
class WatchedRoute : public Route {
public:
  WatchedRoute(const BuiltCase& frame, const BuiltCase& watched, const RowSparse& recovery,
               const StageListener& stage, Timing& timing)
      : frame_(frame), watched_(watched), recovery_(recovery),
        route_(full_route(frame, "", stage, timing)) {}

  void weigh_with(const MatrixXd& rigid, const MatrixXd& weight, const Matrix66& about_origin) {
    Model masses; // of the frame alone
    masses.mesh.nodes = frame_.model.mesh.nodes;
    masses.masses = frame_.model.masses;
    const MatrixXd own = mass_product(masses, rigid);
    weight_ = weight + own;
    about_origin_ = about_origin + rigid.transpose() * own;
  }

  std::string name() const override { return ""; }
  int unknowns() const override { return route_->unknowns(); }
  double mass() const override { return route_->mass(); }
  std::optional<Matrix1212> end_stiffness(const std::array<int, 2>& caps) override {
    return route_->end_stiffness(caps);
  }
  MatrixXd follow(const std::array<int, 2>& caps, const MatrixXd& motion) override {
    return recovery_ * route_->follow(caps, motion);
  }
  ModalSolution modes(const ModesRequest& request, const Loads&,
                      const std::vector<int>& sensors) override {
    ModalSolution s = route_->modes(request, {}, {});
    s.participation = s.u.leftCols(s.modes).transpose() * weight_;
    const CentralMass free = refer_to_centre(about_origin_, s.participation);
    s.mass = free.mass;
    s.free_mass = free.total;
    s.u = (recovery_ * s.u).eval();
    MatrixXd along = s.participation.transpose();
    orient_modes(watched_.model, sensors, s.lambda, along, s.u);
    s.participation = along.transpose();
    return s;
  }

private:
  const BuiltCase& frame_;
  const BuiltCase& watched_;
  const RowSparse& recovery_;
  std::unique_ptr<Route> route_;
  MatrixXd weight_;
  Matrix66 about_origin_;
};

BuiltCase frame_of(const BuiltCase& built, const ReducedModel& reduced) {
  BuiltCase frame;
  frame.model = reduced.model;
  for (const auto& [name, node] : built.cap_nodes)
    frame.cap_nodes[name] = reduced.number[std::size_t(node)];
  for (int node : built.held_nodes) frame.held_nodes.push_back(reduced.number[std::size_t(node)]);
  return frame;
}

} // namespace

AssemblyStudy::AssemblyStudy(std::unique_ptr<const Kept> kept) : kept_(std::move(kept)) {}
AssemblyStudy::~AssemblyStudy() = default;

std::unique_ptr<const AssemblyStudy> AssemblyStudy::of(const Case& data, const StageListener& stage,
                                                       ReductionMemory* memory) {
  if (has_to_run_whole(data)) return nullptr;
  stage(stages::mesh);
  BuiltCase built = build(data);
  if (has_supports(built.model) || !built.dampers.empty() || !built.joints.empty()) return nullptr;
  std::optional<SeenCase> seen = seen_case(built, {});
  if (!seen || seen->nodes.empty()) return nullptr;
  stage(stages::reduction);
  const bool symmetric = data.analyses.symmetry != Symmetry::off;
  if (data.analyses.symmetry == Symmetry::required) return nullptr; // the route checks that
  const ReducedModel reduced =
      reduced_model(cut_between_caps(built, symmetric), part_reduction_request(data.analyses),
                    reduce_here(memory));
  auto kept = std::make_unique<Kept>();
  kept->data = data;
  const DofMap map = eliminate(built.model);
  kept->size = {.nodes = static_cast<int>(built.model.mesh.nodes.size()),
                .elements = element_count(built.model),
                .dofs = map.size(),
                .mass = 0};
  kept->route = route_name(reduced);
  kept->reduced.cutoff = reduction_cutoff(data.analyses);
  if (!reduced.proved) kept->not_proved = "a substructure: " + reduced.reason;
  kept->frame = frame_of(built, reduced);
  if (eliminate(kept->frame.model).size() <= 6 * int(kept->frame.held_nodes.size()))
    return nullptr; // nothing could move: the route says so
  kept->recovery = recovery_of(reduced, seen->nodes);
  kept->watched = std::move(seen->built);
  kept->watched.model.components = {"assembly"}; // no places
  // As ReducedRoute weighs: what is held moves with nothing.
  MatrixXd free = rigid_body_motions(built.model, map, Eigen::Vector3d::Zero());
  for (int dof : node_dofs(map, built.held_nodes)) free.row(dof).setZero();
  const MatrixXd rigid = expand(map, free);
  std::erase_if(built.model.masses,
                [&](const MassElement& m) { return reduced.number[std::size_t(m.node)] >= 0; });
  const MatrixXd force = mass_product(built.model, rigid);
  kept->weight = reduced.gather(force);
  kept->about_origin = rigid.transpose() * force;
  kept->rigid = MatrixXd::Zero(kept->weight.rows(), 6);
  for (std::size_t node = 0; node < reduced.number.size(); ++node)
    if (reduced.number[node] >= 0)
      kept->rigid.middleRows<6>(6 * Index(reduced.number[node])) =
          rigid.middleRows<6>(6 * Index(node));
  return std::unique_ptr<const AssemblyStudy>(new AssemblyStudy(std::move(kept)));
}

std::optional<Results> AssemblyStudy::run(const Case& variant, const StageListener& stage) const {
  BuiltCase frame = kept_->frame;
  if (!renew_ends(frame, kept_->data, variant)) return std::nullopt;
  Results results;
  WatchedRoute route(frame, kept_->watched, kept_->recovery, stage, results.timing);
  route.weigh_with(kept_->rigid, kept_->weight, kept_->about_origin);
  results.case_name = variant.name;
  results.modelled_as = variant.model;
  results.route = kept_->route;
  results.reduced = kept_->reduced;
  results.reduced->unknowns = route.unknowns();
  results.model = kept_->size;
  results.model.mass = route.mass();
  if (variant.analyses.statics.value_or(true) && variant.caps.size() == 2)
    if (const auto K = route.end_stiffness(
            {frame.cap_nodes.at(variant.caps[0].name), frame.cap_nodes.at(variant.caps[1].name)}))
      results.statics = static_stiffness(*K, false);
  if (variant.analyses.modes) run_dynamics(variant, kept_->watched, route, stage, nullptr, results);
  if (!kept_->not_proved.empty() && results.verification.made) {
    results.verification.passed = false;
    results.verification.reason = kept_->not_proved;
  }
  return results;
}

} // namespace plica

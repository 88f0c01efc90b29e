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

#include <algorithm>

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

// Nodes that labels and signs of modes are read from, increasing: of every so manieth ring, and all
// that lie on no wall. Empty when a shell belongs to no ring.
struct Watched {
  std::vector<int> nodes;
  std::vector<Ring> rings; // by these nodes
};

Watched watched_of(const BuiltCase& built) {
  constexpr std::size_t most_rings = 64;
  const Mesh& mesh = built.model.mesh;
  std::vector<char> on_ring(mesh.nodes.size(), 0), seen(mesh.nodes.size(), 1);
  for (const Ring& ring : mesh.rings)
    for (int node : ring.nodes) {
      on_ring[std::size_t(node)] = 1;
      seen[std::size_t(node)] = 0;
    }
  const auto revolved = [&](const auto& shell) {
    return std::all_of(shell.nodes.begin(), shell.nodes.end(),
                       [&](int node) { return on_ring[std::size_t(node)] != 0; });
  };
  if (!std::all_of(mesh.quads.begin(), mesh.quads.end(), revolved) ||
      !std::all_of(mesh.triangles.begin(), mesh.triangles.end(), revolved))
    return {};
  Watched watched;
  const std::size_t stride = (mesh.rings.size() + most_rings - 1) / most_rings;
  for (std::size_t i = 0; i < mesh.rings.size(); i += std::max<std::size_t>(stride, 1)) {
    watched.rings.push_back(mesh.rings[i]);
    for (int node : mesh.rings[i].nodes) seen[std::size_t(node)] = 1;
  }
  for (const BuiltSensor& sensor : built.sensors) seen[std::size_t(sensor.node)] = 1;
  for (std::size_t node = 0; node < seen.size(); ++node)
    if (seen[node]) watched.nodes.push_back(static_cast<int>(node));
  return watched;
}

int number_in(const std::vector<int>& nodes, int node) {
  const auto at = std::lower_bound(nodes.begin(), nodes.end(), node);
  return at != nodes.end() && *at == node ? static_cast<int>(at - nodes.begin()) : -1;
}

// The watched nodes as a model without walls, which names modes as the whole does.
BuiltCase watched_case(const BuiltCase& whole, Watched watched) {
  BuiltCase built;
  const auto renumber = [&](int node) { return number_in(watched.nodes, node); };
  for (int node : watched.nodes)
    built.model.mesh.nodes.push_back(whole.model.mesh.nodes[std::size_t(node)]);
  built.model.components = {"assembly"};
  for (Ring& ring : watched.rings) {
    for (int& node : ring.nodes) node = renumber(node);
    built.model.mesh.rings.push_back(std::move(ring));
  }
  for (BeamElement beam : whole.model.beams) {
    beam.node1 = renumber(beam.node1);
    beam.node2 = renumber(beam.node2);
    beam.component = 0;
    if (beam.node1 >= 0 && beam.node2 >= 0) built.model.beams.push_back(beam);
  }
  for (BushingElement spring : whole.model.bushings) {
    spring.node1 = renumber(spring.node1);
    if (spring.node2 >= 0) spring.node2 = renumber(spring.node2);
    spring.component = 0;
    if (spring.node1 >= 0) built.model.bushings.push_back(spring);
  }
  for (MassElement mass : whole.model.masses)
    if ((mass.node = renumber(mass.node)) >= 0) built.model.masses.push_back(mass);
  for (const auto& [name, node] : whole.cap_nodes) built.cap_nodes[name] = renumber(node);
  for (int node : whole.held_nodes) built.held_nodes.push_back(renumber(node));
  for (BuiltSensor sensor : whole.sensors) {
    sensor.node = renumber(sensor.node);
    built.sensors.push_back(sensor);
  }
  return built;
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
  Watched watched = watched_of(built);
  if (watched.nodes.empty()) return nullptr;
  stage(stages::reduction);
  const bool symmetric = data.analyses.symmetry != Symmetry::off;
  if (data.analyses.symmetry == Symmetry::required) return nullptr; // the route checks that
  const double cutoff = reduction_cutoff(data.analyses);
  const ReducedModel reduced =
      reduced_model(built, interface_nodes(built, symmetric),
                    {.cutoff = cutoff, .symmetry = symmetric, .all_harmonics = true}, memory);
  auto kept = std::make_unique<Kept>();
  kept->data = data;
  const DofMap map = eliminate(built.model);
  kept->size = {.nodes = static_cast<int>(built.model.mesh.nodes.size()),
                .elements = element_count(built.model),
                .dofs = map.size(),
                .mass = 0};
  kept->route = route_name(reduced);
  kept->reduced.cutoff = cutoff;
  if (!reduced.proved) kept->not_proved = "a substructure: " + reduced.reason;
  kept->frame = frame_of(built, reduced);
  if (eliminate(kept->frame.model).size() <= 6 * int(kept->frame.held_nodes.size()))
    return nullptr; // nothing could move: the route says so
  kept->recovery = recovery_of(reduced, watched.nodes);
  kept->watched = watched_case(built, std::move(watched));
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

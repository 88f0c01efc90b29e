#include "run/routes/built_reduced.hpp"
#include "run/routes/route.hpp"
#include "run/stages.hpp"
#include "solve/constraints.hpp"
#include "solve/effective_mass.hpp"
#include "solve/mode_labels.hpp"
#include "solve/stopwatch.hpp"
#include "solve/supports.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <stdexcept>

namespace plica {

using Eigen::Index;
using Eigen::MatrixXd;

std::vector<int> interface_nodes(const BuiltCase& built, bool symmetry) {
  std::set<int> nodes;
  for (const auto& [name, node] : built.cap_nodes) nodes.insert(node);
  for (const BuiltJoint& j : built.joints) {
    if (j.node1 >= 0) nodes.insert(j.node1);
    nodes.insert(j.node2);
  }
  if (!symmetry) return {nodes.begin(), nodes.end()};
  const std::vector<int> broken = nodes_around_breaks(built.model);
  nodes.insert(broken.begin(), broken.end());
  std::vector<char> wall(built.model.mesh.nodes.size(), 0);
  for (const Ring& ring : built.model.mesh.rings)
    for (int node : ring.nodes) wall[node] = 1;
  for (const Constraint& c : built.model.constraints) wall[c.node] = 0;
  const auto attached = [&](int node) {
    if (node >= 0 && wall[node]) nodes.insert(node);
  };
  for (const MassElement& m : built.model.masses) attached(m.node);
  for (const BushingElement& b : built.model.bushings) {
    attached(b.node1);
    attached(b.node2);
  }
  for (const BeamElement& b : built.model.beams) {
    attached(b.node1);
    attached(b.node2);
  }
  return {nodes.begin(), nodes.end()};
}

namespace {

// What cannot be cut or reduced is said of the key that asks for it.
template <class Work> auto of_reduction(const Work& work) {
  try {
    return work();
  } catch (const std::invalid_argument& error) {
    input_error("analyses.reduction", error.what(), "parts that are joined by caps");
  }
}

} // namespace

PartReductionRequest part_reduction_request(const Analyses& analyses) {
  return {.cutoff = reduction_cutoff(analyses),
          .symmetry = analyses.symmetry != Symmetry::off,
          .all_harmonics = true};
}

CutModel cut_between_caps(const BuiltCase& built, bool symmetry) {
  return of_reduction([&] { return cut(built.model, interface_nodes(built, symmetry)); });
}

ReducedModel reduced_model(CutModel pieces, const PartReductionRequest& request,
                           const PartReducer& reduce) {
  return of_reduction([&] { return reduce_substructures(std::move(pieces), request, reduce); });
}

ReducedModel reduced_model(const BuiltCase& built, const std::vector<int>& interface_nodes,
                           const PartReductionRequest& request, const PartReducer& reduce) {
  return reduced_model(of_reduction([&] { return cut(built.model, interface_nodes); }), request,
                       reduce);
}

namespace {

// Independent DOFs of a model that eliminate() takes, without its map.
int independent_count(const Model& model) {
  std::vector<char> held(std::size_t(dof_count(model)), 0);
  for (const Constraint& row : model.constraints) held[std::size_t(6 * row.node + row.dof)] = 1;
  return static_cast<int>(std::count(held.begin(), held.end(), 0));
}

std::string route_name(const PartReduction& part) {
  return part.sectors > 0 ? "rotational symmetry, " + std::to_string(part.sectors) + " sectors"
                          : "full mesh: " + part.because;
}

} // namespace

std::string route_name(const ReducedModel& reduced) {
  std::set<std::string> routes;
  for (const Instance& i : reduced.instances) routes.insert(route_name(*i.reduced));
  std::string text = std::to_string(reduced.instances.size()) + " superelements of " +
                     std::to_string(reduced.reductions) + " reductions";
  for (const std::string& route : routes) text += "; " + route;
  return text;
}

namespace {

// Forces of masses that move with what the mount does not hold, by the coordinates of the frame.
struct RigidWeight {
  MatrixXd force;        // DOFs of the frame x 6: T' M r, r about the origin
  Matrix66 about_origin; // r' M r
};

// M r of the whole by the matrices of the reduced model, in which a rigid motion is one of its
// coordinates; less what the held nodes, and what follows them, have of it.
class RigidMotions {
public:
  RigidMotions(const ReducedModel& reduced, const std::vector<int>& held)
      : reduced_(reduced), held_(held.begin(), held.end()) {}

  RigidWeight weight() {
    const Model& frame = reduced_.model;
    const DofMap map = eliminate(frame);
    const MatrixXd whole = expand(map, rigid_body_motions(frame, map, Eigen::Vector3d::Zero()));
    RigidWeight weight{.force = mass_product(frame, whole), .about_origin = {}};
    weight.about_origin = whole.transpose() * weight.force;
    add_held_frame();
    for (const Instance& instance : reduced_.instances) add_held(instance);
    const MatrixXd cross = whole.transpose() * held_force_;
    weight.force -= held_force_;
    weight.about_origin += held_about_origin_ - cross - cross.transpose();
    return weight;
  }

private:
  // The rigid motions of a model whose nodes move as `held` says, its own numbers; nothing else.
  static MatrixXd moved(const Model& model, const std::vector<int>& held) {
    const DofMap map = eliminate(model);
    MatrixXd r = rigid_body_motions(model, map, Eigen::Vector3d::Zero());
    MatrixXd of_held = MatrixXd::Zero(r.rows(), 6);
    for (int dof : node_dofs(map, held)) of_held.row(dof) = r.row(dof);
    return expand(map, of_held);
  }

  void add_held_frame() {
    Model frame = reduced_.model; // but for the superelements, which stand last
    frame.matrices.resize(frame.matrices.size() - reduced_.instances.size());
    std::vector<int> own;
    for (int node : held_) own.push_back(reduced_.number[node]);
    const MatrixXd r = moved(frame, own);
    held_force_ = mass_product(frame, r);
    held_about_origin_ = r.transpose() * held_force_;
  }

  void add_held(const Instance& instance) {
    const Substructure& part = *instance.part;
    std::vector<int> own;
    for (int node : part.boundary)
      if (held_.contains(part.nodes[node])) own.push_back(node);
    if (own.empty()) return;
    const MatrixXd r = moved(part.model, own), force = mass_product(part.model, r);
    held_about_origin_ += r.transpose() * force;
    std::vector<int> loaded;
    for (Index node = 0; node < Index(part.nodes.size()); ++node)
      if (!force.middleRows<6>(6 * node).isZero(0)) loaded.push_back(int(node));
    MatrixXd at(6 * Index(loaded.size()), 6);
    for (std::size_t i = 0; i < loaded.size(); ++i)
      at.middleRows<6>(6 * Index(i)) = force.middleRows<6>(6 * loaded[i]);
    const Reduction& reduction = instance.reduced->reduction;
    const Index size = reduction.element.K.rows();
    held_force_(rows_of(instance, reduced_.number), Eigen::all) +=
        reduction.field_at(MatrixXd::Identity(size, size), loaded).transpose() * at;
  }

  const ReducedModel& reduced_;
  std::set<int> held_; // nodes of the whole
  MatrixXd held_force_;
  Matrix66 held_about_origin_;
};

// Solves the full route's way what is left when every part between caps is a superelement.
class ReducedRoute : public Route {
public:
  ReducedRoute(const BuiltCase& built, CutModel pieces, const Analyses& analyses,
               const StageListener& stage, Timing& timing, const RouteSettings& settings)
      : built_(built), seen_(settings.seen), cutoff_(reduction_cutoff(analyses)), stage_(stage),
        timing_(timing) {
    reduced_ = reduced_model(std::move(pieces), part_reduction_request(analyses), settings.reduce);
    if (analyses.symmetry == Symmetry::required) require_symmetry();
    watch_.lap(timing_, "reduction");
    frame_.model = reduced_.model;
    for (const auto& [name, node] : built.cap_nodes) frame_.cap_nodes[name] = reduced_.number[node];
    for (int node : built.held_nodes) frame_.held_nodes.push_back(reduced_.number[node]);
    frame_route_ = full_route(frame_, "", stage_, timing_);
    if (eliminate(reduced_.model).size() == 6 * int(built.held_nodes.size()))
      input_error("analyses.reduction.cutoff", "leaves nothing that could move",
                  "a cut-off above the first mode of a part with its caps held");
  }

  std::string name() const override { return route_name(reduced_); }
  std::optional<Reduced> reduced() const override {
    Reduced r{.cutoff = cutoff_, .superelements = {}, .unknowns = frame_route_->unknowns()};
    for (const Instance& i : reduced_.instances) r.superelements.push_back(described(i));
    return r;
  }
  int unknowns() const override { return independent_count(built_.model); }
  double mass() const override { return frame_route_->mass(); }

  std::optional<Matrix1212> end_stiffness(const std::array<int, 2>& caps) override {
    return frame_route_->end_stiffness(in_frame(caps));
  }
  MatrixXd follow(const std::array<int, 2>& caps, const MatrixXd& motion) override {
    return field(frame_route_->follow(in_frame(caps), motion));
  }

  ModalSolution modes(const ModesRequest& request, const Loads& loads,
                      const std::vector<int>& sensors) override {
    Loads reduced{.base = loads.base, .force = {}, .rigid = {}};
    std::optional<WholeMotion> whole; // where a rigid motion is none of the reduced model
    if (supported_inside()) {
      whole = whole_motion();
      reduced.base.assign(loads.base.size(), -1);
    }
    if (!loads.base.empty())
      reduced.force = whole ? reduced_.gather(forces(loads, *whole)) : gather(loads.force);
    ModalSolution s = frame_route_->modes(request, reduced, {});
    if (!reduced_.proved) {
      s.proof.passed = false;
      s.proof.reason = "a substructure: " + reduced_.reason;
    }
    stage_(stages::recovery);
    watch_ = Stopwatch();
    MatrixXd q = std::move(s.u);
    s.u = field(q);
    if (whole)
      weigh(s, s.u.leftCols(s.modes).transpose() * whole->M_free,
            whole->free.transpose() * whole->M_free);
    else
      weigh(s, RigidMotions(reduced_, built_.held_nodes).weight(), q);
    orient(sensors, s, q);
    s.energy = [this, q = std::move(q)](const std::vector<int>& columns) {
      return strain_energy(reduced_, q(Eigen::all, columns));
    };
    watch_.lap(s.timing, "recovery");
    return s;
  }

private:
  MatrixXd field(const MatrixXd& q) const {
    return seen_ ? reduced_.field_at(q, seen_->nodes) : reduced_.field(q);
  }
  MatrixXd gather(const MatrixXd& force) const {
    return seen_ ? reduced_.gather_at(force, seen_->nodes) : reduced_.gather(force);
  }

  // Rigid motions of the whole about the origin, all DOFs x 6.
  struct WholeMotion {
    MatrixXd free;            // of what the mount does not hold
    MatrixXd M_free, M_whole; // masses times it, and times that of what is held, too
  };
  WholeMotion whole_motion() const {
    const DofMap map = eliminate(built_.model);
    MatrixXd free = rigid_body_motions(built_.model, map, Eigen::Vector3d::Zero());
    MatrixXd held = MatrixXd::Zero(free.rows(), 6);
    for (int dof : node_dofs(map, built_.held_nodes)) held.row(dof).swap(free.row(dof));
    MatrixXd both(dof_count(built_.model), 12);
    both << expand(map, free), expand(map, held);
    const MatrixXd M = mass_product(built_.model, both);
    return {both.leftCols(6), M.leftCols(6), M.leftCols(6) + M.rightCols(6)};
  }

  // A rigid motion of the boundary is one of a superelement only where no support holds it inside.
  bool supported_inside() const {
    return std::any_of(reduced_.instances.begin(), reduced_.instances.end(),
                       [](const Instance& i) { return has_supports(i.part->model); });
  }

  // With the motion of the base by the masses of the whole.
  static MatrixXd forces(const Loads& loads, const WholeMotion& whole) {
    MatrixXd force = loads.force;
    for (std::size_t k = 0; k < loads.base.size(); ++k)
      if (loads.base[k] >= 0) force.col(Index(k)) = -whole.M_whole.col(loads.base[k]);
    return force;
  }

  // Effective masses are those of the whole: the coordinates of a superelement are not free and
  // held ones, its modal ones move with both.
  static void weigh(ModalSolution& s, const RigidWeight& rigid, const MatrixXd& q) {
    weigh(s, q.leftCols(s.modes).transpose() * rigid.force, rigid.about_origin);
  }
  static void weigh(ModalSolution& s, const MatrixXd& participation, const Matrix66& about_origin) {
    s.participation = participation;
    const CentralMass free = refer_to_centre(about_origin, s.participation);
    s.mass = free.mass;
    s.free_mass = free.total;
  }

  void require_symmetry() const {
    for (const Instance& i : reduced_.instances)
      if (i.reduced->sectors == 0)
        input_error("analyses.symmetry",
                    "is required, but a part between caps does not repeat around "
                    "its axis: " +
                        i.reduced->because,
                    "mend that, or let symmetry be automatic");
  }

  std::array<int, 2> in_frame(const std::array<int, 2>& caps) const {
    return {reduced_.number[caps[0]], reduced_.number[caps[1]]};
  }

  SuperelementResult described(const Instance& instance) const {
    const Model& own = instance.part->model;
    std::set<std::string> components;
    for (const ShellQuad& q : own.mesh.quads)
      components.insert(own.components[own.shells[q.section].component]);
    for (const ShellTriangle& t : own.mesh.triangles)
      components.insert(own.components[own.shells[t.section].component]);
    for (const BeamElement& b : own.beams) components.insert(own.components[b.component]);
    for (const BushingElement& b : own.bushings) components.insert(own.components[b.component]);
    const Reduction& r = instance.reduced->reduction;
    SuperelementResult result{.parts = {},
                              .between = {},
                              .boundary = r.element.boundary(),
                              .modes = r.element.modal(),
                              .unknowns = independent_count(own),
                              .copy_of = 0,
                              .route = route_name(*instance.reduced),
                              .proved = r.proved};
    for (const std::string& name : components)
      result.parts += (result.parts.empty() ? "" : ", ") + name;
    for (const auto& [name, node] : built_.cap_nodes)
      for (int own_node : instance.part->boundary)
        if (instance.part->nodes[own_node] == node) result.between.push_back(name);
    for (std::size_t k = 0; &reduced_.instances[k] != &instance; ++k)
      if (result.copy_of == 0 && reduced_.instances[k].reduced == instance.reduced)
        result.copy_of = static_cast<int>(k) + 1;
    return result;
  }

  // What turns with the vectors of a pair: their inputs, participations and coordinates.
  void orient(const std::vector<int>& sensors, ModalSolution& s, MatrixXd& q) const {
    const Index loads = s.input.cols();
    MatrixXd along(loads + 6 + q.rows(), s.modes);
    along << s.input.topRows(s.modes).transpose(), s.participation.transpose(), q.leftCols(s.modes);
    MatrixXd u = s.u.leftCols(s.modes);
    orient_modes(seen_ ? seen_->built.model : built_.model, sensors, s.lambda.head(s.modes), along,
                 u);
    s.u.leftCols(s.modes) = u;
    s.input.topRows(s.modes) = along.topRows(loads).transpose();
    s.participation = along.middleRows(loads, 6).transpose();
    q.leftCols(s.modes) = along.bottomRows(q.rows());
  }

  const BuiltCase& built_;
  const SeenCase* seen_;
  double cutoff_;
  const StageListener& stage_;
  Timing& timing_;
  Stopwatch watch_;
  ReducedModel reduced_;
  BuiltCase frame_;
  std::unique_ptr<Route> frame_route_;
};

} // namespace

std::unique_ptr<Route> reduced_route(const BuiltCase& built, CutModel pieces,
                                     const Analyses& analyses, const StageListener& stage,
                                     Timing& timing, const RouteSettings& settings) {
  return std::make_unique<ReducedRoute>(built, std::move(pieces), analyses, stage, timing,
                                        settings);
}

} // namespace plica

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
  std::set<int> wall;
  for (const Ring& ring : built.model.mesh.rings) wall.insert(ring.nodes.begin(), ring.nodes.end());
  for (const Constraint& c : built.model.constraints) wall.erase(c.node);
  const auto attached = [&](int node) {
    if (wall.contains(node)) nodes.insert(node);
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

ReducedModel reduced_model(const BuiltCase& built, const std::vector<int>& interface_nodes,
                           const ReductionRequest& request, ReductionMemory* memory) {
  try {
    return reduce_substructures(built.model, interface_nodes, request, memory);
  } catch (const std::invalid_argument& error) {
    input_error("analyses.reduction", error.what(), "parts that are joined by caps");
  }
}

namespace {

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

// Solves the full route's way what is left when every part between caps is a superelement.
class ReducedRoute : public Route {
public:
  ReducedRoute(const BuiltCase& built, double cutoff, Symmetry symmetry, const StageListener& stage,
               Timing& timing, ReductionMemory* memory)
      : built_(built), cutoff_(cutoff), stage_(stage), timing_(timing),
        map_(eliminate(built.model)) {
    stage_(stages::reduction);
    const bool symmetric = symmetry != Symmetry::off;
    reduced_ =
        reduced_model(built, interface_nodes(built, symmetric),
                      {.cutoff = cutoff, .symmetry = symmetric, .all_harmonics = true}, memory);
    if (symmetry == Symmetry::required) require_symmetry();
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
  int unknowns() const override { return map_.size(); }
  double mass() const override { return frame_route_->mass(); }

  std::optional<Matrix1212> end_stiffness(const std::array<int, 2>& caps) override {
    return frame_route_->end_stiffness(in_frame(caps));
  }
  MatrixXd follow(const std::array<int, 2>& caps, const MatrixXd& motion) override {
    return reduced_.field(frame_route_->follow(in_frame(caps), motion));
  }

  ModalSolution modes(const ModesRequest& request, const Loads& loads,
                      const std::vector<int>& sensors) override {
    const bool supported = supported_inside();
    const RigidMotion rigid = rigid_motion();
    const Loads reduced{.base = supported ? std::vector<int>(loads.base.size(), -1) : loads.base,
                        .force =
                            loads.base.empty()
                                ? MatrixXd()
                                : reduced_.gather(supported ? forces(loads, rigid) : loads.force),
                        .rigid = {}};
    ModalSolution s = frame_route_->modes(request, reduced, {});
    if (!reduced_.proved) {
      s.proof.passed = false;
      s.proof.reason = "a substructure: " + reduced_.reason;
    }
    stage_(stages::recovery);
    watch_ = Stopwatch();
    s.u = reduced_.field(s.u);
    weigh(s, rigid);
    orient(sensors, s);
    watch_.lap(s.timing, "recovery");
    return s;
  }

private:
  // Of the whole about the origin, all DOFs x 6.
  struct RigidMotion {
    MatrixXd free;            // of what the mount does not hold
    MatrixXd M_free, M_whole; // masses times it, and times that of what is held, too
  };
  RigidMotion rigid_motion() const {
    MatrixXd free = rigid_body_motions(built_.model, map_, Eigen::Vector3d::Zero());
    MatrixXd held = MatrixXd::Zero(free.rows(), 6);
    for (int dof : node_dofs(map_, built_.held_nodes)) held.row(dof).swap(free.row(dof));
    MatrixXd both(dof_count(built_.model), 12);
    both << expand(map_, free), expand(map_, held);
    const MatrixXd M = mass_product(built_.model, both);
    return {both.leftCols(6), M.leftCols(6), M.leftCols(6) + M.rightCols(6)};
  }

  // A rigid motion of the boundary is one of a superelement only where no support holds it inside.
  bool supported_inside() const {
    return std::any_of(reduced_.instances.begin(), reduced_.instances.end(),
                       [](const Instance& i) { return has_supports(i.part->model); });
  }

  // With the motion of the base by the masses of the whole.
  static MatrixXd forces(const Loads& loads, const RigidMotion& rigid) {
    MatrixXd force = loads.force;
    for (std::size_t k = 0; k < loads.base.size(); ++k)
      if (loads.base[k] >= 0) force.col(Index(k)) = -rigid.M_whole.col(loads.base[k]);
    return force;
  }

  // Effective masses are those of the whole: the coordinates of a superelement are not free and
  // held ones, its modal ones move with both.
  static void weigh(ModalSolution& s, const RigidMotion& rigid) {
    s.participation = s.u.leftCols(s.modes).transpose() * rigid.M_free;
    const CentralMass free =
        refer_to_centre(rigid.free.transpose() * rigid.M_free, s.participation);
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
                              .unknowns = eliminate(own).size(),
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

  // What turns with the vectors of a pair: their inputs and participations.
  void orient(const std::vector<int>& sensors, ModalSolution& s) const {
    const Index loads = s.input.cols();
    MatrixXd along(loads + 6, s.modes);
    along << s.input.topRows(s.modes).transpose(), s.participation.transpose();
    MatrixXd u = s.u.leftCols(s.modes);
    orient_modes(built_.model, sensors, s.lambda.head(s.modes), along, u);
    s.u.leftCols(s.modes) = u;
    s.input.topRows(s.modes) = along.topRows(loads).transpose();
    s.participation = along.bottomRows(6).transpose();
  }

  const BuiltCase& built_;
  double cutoff_;
  const StageListener& stage_;
  Timing& timing_;
  Stopwatch watch_;
  DofMap map_; // of the whole
  ReducedModel reduced_;
  BuiltCase frame_;
  std::unique_ptr<Route> frame_route_;
};

} // namespace

std::unique_ptr<Route> reduced_route(const BuiltCase& built, double cutoff, Symmetry symmetry,
                                     const StageListener& stage, Timing& timing,
                                     ReductionMemory* memory) {
  return std::make_unique<ReducedRoute>(built, cutoff, symmetry, stage, timing, memory);
}

} // namespace plica

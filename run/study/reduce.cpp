#include "run/study/reduce.hpp"

#include "model/description/place_keys.hpp"
#include "reduction/craig_bampton.hpp"
#include "run/analyses/damping.hpp"
#include "run/analyses/response.hpp"
#include "run/routes/built_reduced.hpp"
#include "run/routes/memory_need.hpp"
#include "run/routes/operating_state.hpp"
#include "run/routes/route.hpp"
#include "run/stages.hpp"
#include "run/study/part_reference.hpp"
#include "run/study/reduce_state.hpp"
#include "solve/decompositions.hpp"
#include "solve/stopwatch.hpp"
#include "solve/strain_energy.hpp"
#include "solve/stress.hpp"
#include "words/did_you_mean.hpp"
#include "words/directions.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

void check_boundary_names(const Case& data, const std::vector<std::string>& asked) {
  std::vector<std::string> known;
  for (const Cap& cap : data.caps) known.push_back(cap.name);
  for (const Sensor& sensor : data.sensors) known.push_back(sensor.name);
  std::string list;
  for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
  std::vector<InputProblem> problems;
  const auto problem = [&](const std::string& wrong) {
    problems.push_back({.file = "",
                        .line = 0,
                        .key = "boundary",
                        .wrong = wrong,
                        .allowed = "allowed: names of caps and sensors, each once: " + list});
  };
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const auto matches = std::count(known.begin(), known.end(), asked[i]);
    if (matches == 0) problem("there is no cap and no sensor '" + asked[i] + "'");
    if (matches > 1) problem("'" + asked[i] + "' is the name of a cap and of a sensor");
    if (std::find(asked.begin(), asked.begin() + long(i), asked[i]) != asked.begin() + long(i))
      problem("'" + asked[i] + "' is given twice");
  }
  if (!problems.empty()) throw InputError(problems);
}

void check_recovered(const Case& data, const std::vector<std::string>& asked) {
  std::vector<std::string> known;
  for (const Sensor& sensor : data.sensors) known.push_back(sensor.name);
  for (const std::string& name : asked)
    if (std::find(known.begin(), known.end(), name) == known.end())
      input_error("recover", "there is no sensor '" + name + "'", suggestion(name, known));
}

Boundary boundary_of(const Case& data, const BuiltCase& built,
                     const std::vector<std::string>& asked) {
  const auto wanted = [&](const std::string& name) {
    return std::find(asked.begin(), asked.end(), name) != asked.end();
  };
  check_boundary_names(data, asked);
  Boundary b;
  for (const Cap& cap : data.caps) {
    if (!asked.empty() && !wanted(cap.name)) continue;
    b.names.push_back(cap.name);
    b.nodes.push_back(built.cap_nodes.at(cap.name));
    ++b.caps;
  }
  for (const BuiltSensor& sensor : built.sensors) {
    if (!wanted(sensor.name)) continue;
    b.names.push_back(sensor.name);
    b.nodes.push_back(sensor.node);
  }
  if (b.caps == 0)
    input_error("caps", "gives no cap for the boundary, and that is how a superelement is held",
                "at least one cap");
  return b;
}

Reduction reduce(const BuiltCase& built, const SymmetricView& view,
                 const std::shared_ptr<const ReducedModel>& nested, const Boundary& boundary,
                 double cutoff) {
  try {
    if (nested) return craig_bampton(nested, boundary.nodes, cutoff);
    if (const auto* symmetric = std::get_if<CyclicModel>(&view))
      return craig_bampton(*symmetric, boundary.nodes, cutoff);
    return craig_bampton(built.model, boundary.nodes, cutoff);
  } catch (const std::invalid_argument& error) {
    input_error("caps", error.what(), "caps and sensors that nothing else holds, each once");
  }
}

// Shells that meet in a node, as a model of their own; the node's own number there.
struct Patch {
  Model model;
  std::vector<int> nodes; // number in the whole
  int centre = 0;
};

Patch patch_around(const Model& model, int node) {
  Patch patch;
  patch.model.shells = model.shells;
  const auto add = [&](auto own, auto& shells) {
    if (std::find(own.nodes.begin(), own.nodes.end(), node) == own.nodes.end()) return;
    for (int& n : own.nodes) {
      const auto known = std::find(patch.nodes.begin(), patch.nodes.end(), n);
      if (n == node) patch.centre = int(known - patch.nodes.begin());
      if (known == patch.nodes.end()) {
        patch.nodes.push_back(n);
        n = add_node(patch.model, model.mesh.nodes[n]);
      } else {
        n = int(known - patch.nodes.begin());
      }
    }
    shells.push_back(own);
  };
  for (const ShellQuad& quad : model.mesh.quads) add(quad, patch.model.mesh.quads);
  for (const ShellTriangle& t : model.mesh.triangles) add(t, patch.model.mesh.triangles);
  return patch;
}

// Stress of the wall at a sensor; a kink has one entry per side.
void add_stress_rows(Superelement& s, const Reduction& reduction, const Model& model,
                     const BuiltSensor& sensor) {
  const Patch patch = patch_around(model, sensor.node);
  if (patch.nodes.empty()) return;
  const MatrixXd u = reduction.field_at(MatrixXd::Identity(s.K.rows(), s.K.rows()), patch.nodes);
  const StressField field = recover_stress(patch.model, u);
  int side = 0;
  for (std::size_t point = 0; point < field.node_of_point.size(); ++point) {
    if (field.node_of_point[point] != patch.centre) continue;
    ++side;
    s.stresses.push_back({.name = sensor.name + (side > 1 ? ", side " + std::to_string(side) : ""),
                          .place = model.mesh.nodes[sensor.node],
                          .rows = field.shell.middleRows<12>(12 * Index(point))});
  }
}

void add_loads(Superelement& s, const Reduction& reduction, const BuiltCase& built,
               const std::optional<Response>& response) {
  const MatrixXd base = s.M * rigid_motions(s, Eigen::Vector3d::Zero());
  for (int d = 0; d < 6; ++d)
    s.loads.push_back(
        {.name = std::string("base ") + direction_names[d] + (d < 3 ? " per m/s2" : " per rad/s2"),
         .force = -base.col(d)});
  if (!response || response->forces.empty()) return;
  Response forced = *response;
  forced.bases.clear();
  forced.motions.clear();
  forced.together.clear();
  const Excitations forces = excitations(forced, built);
  const MatrixXd identity = MatrixXd::Identity(s.K.rows(), s.K.rows());
  for (const Excitation& e : forces.list) {
    const auto column = forces.loads.force.col(e.parts[0].column);
    std::vector<int> nodes;
    for (int node = 0; node < column.size() / 6; ++node)
      if (!column.segment<6>(6 * node).isZero(0)) nodes.push_back(node);
    VectorXd own(6 * Index(nodes.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i)
      own.segment<6>(6 * Index(i)) = column.segment<6>(6 * nodes[i]);
    s.loads.push_back({.name = e.name + " per " + e.unit,
                       .force = reduction.field_at(identity, nodes).transpose() * own});
  }
}

// Dashpots and loss factors of the joints between ends: matrices know no other damping.
void add_dampers(Superelement& s, const Reduction& reduction, const BuiltCase& built) {
  const MatrixXd identity = MatrixXd::Identity(s.K.rows(), s.K.rows());
  for (const BuiltDamper& d : built.dampers) {
    if (!d.law.maxwell.empty() || d.law.springpot || !d.law.table.empty())
      input_error(d.place + ".damping",
                  "depends on frequency, which no matrix of a superelement can",
                  "dashpot or loss_factor");
    const VectorXd force = unit_force(built.model, d.node1, d.node2, d.dof);
    const std::vector<int> nodes{d.node1, d.node2};
    VectorXd own(12);
    own << force.segment<6>(6 * d.node1), force.segment<6>(6 * d.node2);
    const VectorXd b = reduction.field_at(identity, nodes).transpose() * own;
    const auto add = [&](MatrixXd& matrix, double factor) {
      if (factor == 0) return;
      if (matrix.size() == 0) matrix = MatrixXd::Zero(s.K.rows(), s.K.rows());
      matrix += factor * b * b.transpose();
    };
    add(s.C, d.law.dashpot ? (*d.law.dashpot)[std::size_t(d.dof)] : 0);
    add(s.D, d.law.loss_factor * d.stiffness);
  }
}

// Recovery rows, loads, viscous damping of the modes, structural damping of the components.
void complete(Superelement& s, const Reduction& reduction, const BuiltCase& built,
              const Analyses& analyses, const std::vector<std::string>& recover) {
  const auto size = s.K.rows();
  const MatrixXd identity = MatrixXd::Identity(size, size);
  std::vector<int> nodes;
  for (const BuiltSensor& sensor : built.sensors) nodes.push_back(sensor.node);
  const MatrixXd rows = reduction.field_at(identity, nodes);
  for (std::size_t k = 0; k < built.sensors.size(); ++k) {
    if (!recover.empty() &&
        std::find(recover.begin(), recover.end(), built.sensors[k].name) == recover.end())
      continue;
    s.recovery.push_back({.name = built.sensors[k].name,
                          .place = built.model.mesh.nodes[nodes[k]],
                          .rows = rows.middleRows<6>(6 * Index(k))});
    add_stress_rows(s, reduction, built.model, built.sensors[k]);
  }
  add_loads(s, reduction, built, analyses.response);
  const Damping& damping = analyses.damping;
  const VectorXd lambda = reduction.lambda;
  const ModalDamping modal = modal_damping({.modal = damping.modal, .ranges = damping.ranges},
                                           built.model, lambda, Eigen::MatrixXd(), 0);
  if (modal.zeta.size() > 0 && modal.zeta.maxCoeff() > 0) {
    s.C = MatrixXd::Zero(size, size);
    s.C.diagonal().tail(lambda.size()) = 2 * modal.zeta.cwiseProduct(lambda.cwiseSqrt());
  }
  add_dampers(s, reduction, built);
  if (damping.loss_factors.empty()) return;
  if (s.D.size() == 0) s.D = MatrixXd::Zero(size, size);
  const std::vector<MatrixXd> parts = component_stiffness(built.model, reduction.field(identity));
  for (const LossFactor& loss : damping.loss_factors)
    for (std::size_t c = 0; c < parts.size(); ++c)
      if (built.model.components[c] == loss.of && !(damping.coupled && is_springs(loss.of)))
        s.D += loss.value / 2 * (parts[c] + parts[c].transpose());
}

// Forces that the motions left to a held part raise are rounding, as those of a free part are.
void take_rounding_out(Superelement& s, const MatrixXd& free_motions) {
  if (free_motions.cols() == 0) return;
  const Index n = s.boundary();
  const VectorXd scale = s.M.diagonal().head(n).cwiseSqrt();
  const MatrixXd R = rigid_motions(s, Eigen::Vector3d::Zero()).topRows(n) * free_motions;
  const MatrixXd Q = orthonormal_columns(scale.asDiagonal() * R);
  const MatrixXd P = scale.asDiagonal() * (MatrixXd::Identity(n, n) - Q * Q.transpose()) *
                     scale.cwiseInverse().asDiagonal();
  const MatrixXd K = P * s.K.topLeftCorner(n, n) * P.transpose();
  s.K.topLeftCorner(n, n) = (K + K.transpose()) / 2;
}

// Leaves out the modes that the boundary hardly feels.
ModesLeftOut select_modes(Reduction& reduction, double least) {
  const VectorXd share = effective_interface_mass(reduction.element);
  std::vector<int> kept;
  ModesLeftOut out;
  for (Index j = 0; j < share.size(); ++j) {
    if (share[j] >= least) {
      kept.push_back(int(j));
      continue;
    }
    const double hertz = frequency(reduction.lambda[j]);
    out.lowest = out.count == 0 ? hertz : std::min(out.lowest, hertz);
    ++out.count;
    out.largest = std::max(out.largest, share[j]);
    out.sum += share[j];
  }
  if (out.count > 0) reduction = with_modes(reduction, kept);
  return out;
}

} // namespace

ReducedCase reduce_case(const Case& given, const SuperelementRequest& request,
                        const StageListener& stage) {
  Case data = given;
  if (!data.state) data.mount.clear(); // whoever takes the superelement holds it
  ReducedCase result;
  result.cutoff = request.cutoff > 0 ? request.cutoff : reduction_cutoff(data.analyses);
  result.asked = highest_frequency(data.analyses);
  Stopwatch watch;
  stage(stages::mesh);
  const ReleasedCase released =
      data.state ? released_in_state(data, stage, result.timing) : ReleasedCase{build(data), {}};
  const BuiltCase& built = released.built;
  if (data.state) result.state = released.state;
  const Boundary boundary = boundary_of(data, built, request.boundary);
  if (data.state) check_reducible(data, boundary.names);
  check_recovered(data, request.recover);
  watch.lap(result.timing, "mesh");
  stage(stages::symmetry);
  const SymmetricView view = symmetric_view(built.model, data.analyses.symmetry);
  const auto* symmetric = std::get_if<CyclicModel>(&view);
  watch.lap(result.timing, "symmetry");
  require_memory_for(built, data.analyses, view);
  stage(stages::reduction);
  std::shared_ptr<const ReducedModel> nested;
  if (data.analyses.reduction) {
    const bool by_symmetry = data.analyses.symmetry != Symmetry::off;
    std::vector<int> meeting = interface_nodes(built, by_symmetry);
    meeting.insert(meeting.end(), boundary.nodes.begin(), boundary.nodes.end());
    nested = std::make_shared<const ReducedModel>(
        reduced_model(built, meeting, {.cutoff = result.cutoff, .symmetry = by_symmetry}));
  }
  result.route = nested ? route_name(*nested)
                 : symmetric
                     ? "rotational symmetry, " + std::to_string(symmetric->around()) + " sectors"
                     : "full mesh: " + std::get<std::string>(view);
  Reduction reduction = reduce(built, view, nested, boundary, result.cutoff);
  reduction.element.name = data.name;
  reduction.element.node_names = boundary.names;
  watch.lap(result.timing, "reduction");
  stage(stages::certificate);
  const bool preloaded = data.state.has_value();
  const bool grounded = !data.supports.empty() || held_by_deck(data);
  PartReference part = part_reference(built, view, boundary, grounded, preloaded, result.cutoff);
  if (preloaded) part.preload = forces_of_rigid_motions(data, released, boundary.nodes);
  if (boundary.caps == 2) add_statics(part, built, view, boundary, nested != nullptr);
  take_rounding_out(reduction.element, part.free_motions);
  result.left_out = select_modes(reduction, request.least_interface_mass);
  part.left_out = result.left_out.count;
  result.certificate = certificate(reduction.element, part);
  watch.lap(result.timing, stages::certificate);
  stage(stages::recovery);
  result.element = reduction.element;
  result.proved = reduction.proved;
  result.reason = reduction.reason;
  complete(result.element, reduction, built, data.analyses, request.recover);
  watch.lap(result.timing, "recovery");
  result.peak_memory = peak_memory();
  return result;
}

} // namespace plica

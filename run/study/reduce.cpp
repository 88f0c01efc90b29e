#include "run/study/reduce.hpp"

#include "reduction/craig_bampton.hpp"
#include "reduction/cyclic_modes.hpp"
#include "run/analyses/damping.hpp"
#include "run/analyses/response.hpp"
#include "run/routes/built_reduced.hpp"
#include "run/routes/operating_state.hpp"
#include "run/routes/route.hpp"
#include "solve/parallel.hpp"
#include "solve/stopwatch.hpp"
#include "solve/strain_energy.hpp"
#include "solve/stress.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Boundary {
  std::vector<std::string> names;
  std::vector<int> nodes;
  int caps = 0; // they come first
};

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

ModeSet modes_up_to(const SparseMatrix& K, const SparseMatrix& M, double high) {
  BaseFactor base = factor_below_spectrum(K, M);
  return find_modes(K, M, {.band = {0, high}, .proof = false}, base);
}

// Motion of the boundary nodes, six rows each, in modes of a family with nothing held.
MatrixXd boundary_motion(const HarmonicSystem& system, const std::vector<int>& nodes,
                         const MatrixXd& Phi) {
  MatrixXd motion = MatrixXd::Zero(6 * Index(nodes.size()), Phi.cols());
  for (std::size_t k = 0; k < nodes.size(); ++k)
    for (const AxisUnknown& a : system.axis)
      if (a.node == nodes[k] && a.number >= 0)
        motion.middleRows<6>(6 * Index(k)) += a.direction * Phi.row(a.number);
  return motion;
}

// Of the harmonics that reach the caps, pairs twice; first free, then held at the caps.
void add_symmetric_spectra(PartReference& part, const CyclicModel& model,
                           const std::vector<int>& caps, double high) {
  constexpr std::array families{Harmonic{0, false}, Harmonic{0, true}, Harmonic{1, false}};
  struct Mode {
    double lambda = 0;
    VectorXd motion;
  };
  std::array<std::vector<Mode>, 2 * families.size()> found;
  in_parallel(int(found.size()), [&](int i) {
    const Harmonic& harmonic = families[std::size_t(i / 2)];
    const bool free = i % 2 == 0;
    const CyclicFamily f = cyclic_family(model, harmonic, free ? std::vector<int>{} : caps);
    const ModeSet modes = modes_up_to(f.K, f.M, high);
    const auto add = [&](const HarmonicSystem& system) {
      const MatrixXd motion = free ? boundary_motion(system, caps, modes.Phi) : MatrixXd();
      for (Index j = 0; j < modes.lambda.size(); ++j)
        found[std::size_t(i)].push_back(
            {modes.lambda[j], free ? VectorXd(motion.col(j)) : VectorXd()});
    };
    add(f.system);
    if (harmonic.n == 1) add(model.quarter_turned(f.system));
  });
  for (const bool free : {true, false}) {
    std::vector<Mode> all;
    for (std::size_t i = free ? 0 : 1; i < found.size(); i += 2)
      all.insert(all.end(), found[i].begin(), found[i].end());
    std::stable_sort(all.begin(), all.end(),
                     [](const Mode& a, const Mode& b) { return a.lambda < b.lambda; });
    VectorXd& lambda = free ? part.free_lambda : part.fixed_lambda;
    lambda.resize(Index(all.size()));
    if (free) part.free_motion.resize(6 * Index(caps.size()), Index(all.size()));
    for (std::size_t j = 0; j < all.size(); ++j) {
      lambda[Index(j)] = all[j].lambda;
      if (free) part.free_motion.col(Index(j)) = all[j].motion;
    }
  }
}

PartReference symmetric_reference(const CyclicModel& model, const Boundary& boundary, double high) {
  PartReference part;
  part.rigid_mass.setZero();
  for (const Harmonic& h :
       {Harmonic{0, false}, Harmonic{0, true}, Harmonic{1, false}, Harmonic{1, true}}) {
    const HarmonicSystem s = model.system(h);
    const MatrixXd r = model.rigid_motions(s);
    part.rigid_mass += r.transpose() * symmetric_product(s.M, r);
  }
  if (boundary.caps == static_cast<int>(boundary.nodes.size())) {
    add_symmetric_spectra(part, model, boundary.nodes, high);
    return part;
  }
  // A node on the wall is reached by every harmonic; held, it would end the symmetry.
  const CyclicModes modes = find_cyclic_modes(model, {}, {.band = {0, high}, .proof = false});
  part.free_lambda.resize(Index(modes.modes.size()));
  for (std::size_t i = 0; i < modes.modes.size(); ++i)
    part.free_lambda[Index(i)] = modes.modes[i].lambda;
  return part;
}

PartReference full_reference(const Model& model, const Boundary& boundary, double high) {
  const System system = assemble(model);
  PartReference part;
  const MatrixXd r = rigid_body_motions(model, system.map, Eigen::Vector3d::Zero());
  part.rigid_mass = r.transpose() * symmetric_product(system.M, r);
  const std::vector<int> inner =
      complement(system.map.size(), node_dofs(system.map, boundary.nodes));
  const ModeSet free = modes_up_to(system.K, system.M, high);
  part.free_lambda = free.lambda;
  part.free_motion.resize(6 * Index(boundary.nodes.size()), free.Phi.cols());
  for (std::size_t k = 0; k < boundary.nodes.size(); ++k)
    for (int d = 0; d < 6; ++d)
      part.free_motion.row(6 * Index(k) + d) =
          free.Phi.row(system.map.independent[6 * boundary.nodes[k] + d]);
  part.fixed_lambda =
      modes_up_to(restrict_to(system.K, inner), restrict_to(system.M, inner), high).lambda;
  return part;
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
  constexpr std::array axes{"x", "y", "z", "rx", "ry", "rz"};
  const MatrixXd base = s.M * rigid_motions(s, Eigen::Vector3d::Zero());
  for (int d = 0; d < 6; ++d)
    s.loads.push_back(
        {.name = std::string("base ") + axes[d] + (d < 3 ? " per m/s2" : " per rad/s2"),
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
              const Analyses& analyses) {
  const auto size = s.K.rows();
  const MatrixXd identity = MatrixXd::Identity(size, size);
  std::vector<int> nodes;
  for (const BuiltSensor& sensor : built.sensors) nodes.push_back(sensor.node);
  const MatrixXd rows = reduction.field_at(identity, nodes);
  for (std::size_t k = 0; k < built.sensors.size(); ++k) {
    s.recovery.push_back({.name = built.sensors[k].name,
                          .place = built.model.mesh.nodes[nodes[k]],
                          .rows = rows.middleRows<6>(6 * Index(k))});
    add_stress_rows(s, reduction, built.model, built.sensors[k]);
  }
  add_loads(s, reduction, built, analyses.response);
  const Damping& damping = analyses.damping;
  const VectorXd lambda = reduction.lambda;
  const ModalDamping modal =
      modal_damping({.modal = damping.modal, .ranges = damping.ranges}, built.model, lambda, {}, 0);
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

// By another way than the reduction.
void add_statics(PartReference& part, const BuiltCase& built, const SymmetricView& view,
                 const Boundary& boundary, bool nested) {
  std::map<std::string, double> ignored;
  const StageListener quiet = [](const std::string&) {};
  const auto* symmetric = std::get_if<CyclicModel>(&view);
  const auto route = symmetric ? cyclic_route(built, *symmetric, quiet, ignored)
                               : full_route(built, "", quiet, ignored);
  const std::array<int, 2> caps{boundary.nodes[0], boundary.nodes[1]};
  const std::vector<Eigen::Vector3d> places{built.model.mesh.nodes[caps[0]],
                                            built.model.mesh.nodes[caps[1]]};
  const Matrix1212 K = *route->end_stiffness(caps);
  // A superelement of superelements sums its parts in another order than the mesh does, and one
  // with further boundary nodes has its rounding spread over them before it is taken out.
  if ((nested || boundary.nodes.size() > 2) && !part.grounded)
    part.statics_known_to = grounding(K, places);
  part.static_stiffness = without_grounding(K, places);
}

} // namespace

ReducedCase reduce_case(const Case& given, const SuperelementRequest& request,
                        const std::function<void(const std::string&)>& stage) {
  require_rest(given, "a superelement");
  Case data = given;
  data.mount.clear(); // whoever takes the superelement holds it
  ReducedCase result;
  result.cutoff = request.cutoff > 0 ? request.cutoff : reduction_cutoff(data.analyses);
  result.asked = highest_frequency(data.analyses);
  Stopwatch watch;
  stage("mesh");
  const BuiltCase built = build(data);
  const Boundary boundary = boundary_of(data, built, request.boundary);
  watch.lap(result.timing, "mesh");
  stage("symmetry");
  const SymmetricView view = symmetric_view(built.model, data.analyses.symmetry);
  const auto* symmetric = std::get_if<CyclicModel>(&view);
  watch.lap(result.timing, "symmetry");
  stage("reduction");
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
  stage("certificate");
  PartReference part = symmetric ? symmetric_reference(*symmetric, boundary, result.cutoff)
                                 : full_reference(built.model, boundary, result.cutoff);
  part.grounded = !data.supports.empty() || held_by_deck(data);
  if (boundary.caps == 2) add_statics(part, built, view, boundary, nested != nullptr);
  result.left_out = select_modes(reduction, request.least_interface_mass);
  part.left_out = result.left_out.count;
  result.certificate = certificate(reduction.element, part);
  watch.lap(result.timing, "certificate");
  stage("recovery");
  result.element = reduction.element;
  result.proved = reduction.proved;
  result.reason = reduction.reason;
  complete(result.element, reduction, built, data.analyses);
  watch.lap(result.timing, "recovery");
  result.peak_memory = peak_memory();
  return result;
}

} // namespace plica

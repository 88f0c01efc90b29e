#include "model/run.hpp"

#include "model/damping.hpp"
#include "model/input_error.hpp"
#include "model/run_stress.hpp"
#include "solve/effective_mass.hpp"
#include "solve/mode_labels.hpp"
#include "solve/modes.hpp"
#include "solve/statics.hpp"
#include "solve/stopwatch.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::MatrixXd;

std::vector<int> node_dofs(const DofMap& map, const std::vector<int>& nodes) {
  std::vector<int> dofs;
  for (int node : nodes)
    for (int dof = 6 * node; dof < 6 * node + 6; ++dof)
      if (map.independent[dof] >= 0) dofs.push_back(map.independent[dof]);
  std::sort(dofs.begin(), dofs.end());
  return dofs;
}

System assemble_case(const BuiltCase& built) {
  try {
    return assemble(built.model);
  } catch (const ConstraintError& error) {
    throw InputError({{.file = "", .line = 0, .key = "", .wrong = error.what(), .allowed = ""}});
  } catch (const std::invalid_argument& error) {
    throw InputError({{.file = "", .line = 0, .key = "", .wrong = error.what(), .allowed = ""}});
  }
}

// The free part of the system: what is not held by a rigid mount.
struct FreeSystem {
  std::vector<int> free, held;
  SparseMatrix K, M;
};

FreeSystem free_system(const System& system, const BuiltCase& built) {
  FreeSystem part;
  part.held = node_dofs(system.map, built.held_nodes);
  part.free = complement(system.map.size(), part.held);
  part.K = restrict_to(system.K, part.free);
  part.M = restrict_to(system.M, part.free);
  return part;
}

class Run {
public:
  Run(const Case& data, const std::function<void(const std::string&)>& stage)
      : case_(data), stage_(stage) {}

  Results results() {
    stage_("mesh");
    built_ = build(case_);
    lap("mesh");
    stage_("assembly");
    system_ = assemble_case(built_);
    part_ = free_system(system_, built_);
    lap("assembly");
    describe();
    if (case_.analyses.statics && case_.caps.size() == 2) statics();
    if (case_.analyses.modes) modes();
    results_.peak_memory = peak_memory();
    return std::move(results_);
  }

private:
  void lap(const std::string& name) { watch_.lap(results_.timing, name); }

  void describe() {
    results_.case_name = case_.name;
    results_.title = case_.title;
    results_.assumptions = case_.assumptions;
    results_.quality = mesh_quality(built_.model.mesh);
    results_.meridian = built_.meridian;
    for (const BeamElement& b : built_.model.beams) results_.lines.push_back({b.node1, b.node2});
    for (const BuiltSensor& s : built_.sensors)
      results_.sensors.push_back({s.name, s.node, s.distance});
    const std::vector<int> all = complement(system_.map.size(), {});
    results_.model = {.nodes = static_cast<int>(built_.model.mesh.nodes.size()),
                      .elements = element_count(built_.model),
                      .dofs = system_.map.size(),
                      .mass = free_mass(built_.model, system_.map, all, system_.M).mass};
    results_.mesh = built_.model.mesh;
  }

  BaseFactor& base() {
    if (!base_) {
      stage_("factorisation");
      base_.emplace(factor_below_spectrum(part_.K, part_.M));
      lap("factorisation");
    }
    return *base_;
  }

  void statics() {
    // The rig holds both caps; with another mount the stiffness is that of the part alone.
    std::vector<int> caps;
    for (const Cap& cap : case_.caps) caps.push_back(built_.cap_nodes.at(cap.name));
    const std::vector<int> boundary = node_dofs(system_.map, caps);
    if (boundary.size() != 12) {
      results_.warnings.push_back("static stiffness left out: a support holds a cap");
      return;
    }
    const bool shared = boundary == part_.held && base().sigma == 0;
    std::optional<SparseFactor> own;
    stage_("statics");
    SparseMatrix K = system_.K;
    for (const BushingElement& b : built_.model.bushings) // a spring mount is not the part
      if (b.node2 < 0)
        add_dense(K, node_dofs(system_.map, {b.node1}), -ground_bushing_matrix(b.bushing));
    if (!shared) {
      const SparseMatrix inner = restrict_to(K, complement(system_.map.size(), boundary));
      own.emplace(inner);
      if (!own->factorise(inner).ok)
        throw std::runtime_error(
            "static stiffness: the part is a mechanism when both caps are held");
    }
    const SparseFactor& inner = shared ? base().factor : *own;
    MatrixXd condensed = condense(K, boundary, inner);
    if (case_.analyses.stress)
      static_stress(K, boundary, inner, condensed, caps[0] > caps[1] ? 0 : 6);
    if (caps[0] > caps[1]) { // order of the caps in the case
      const Eigen::PermutationMatrix<12> swap(
          (Eigen::Matrix<int, 12, 1>() << 6, 7, 8, 9, 10, 11, 0, 1, 2, 3, 4, 5).finished());
      condensed = swap * condensed * swap.transpose();
    }
    const EndStiffness k = end_stiffness(condensed.bottomRightCorner<6, 6>());
    results_.statics = {.k_axial = k.axial,
                        .k_transverse_x = k.transverse_x,
                        .k_transverse_z = k.transverse_z,
                        .k_bending_x = k.bending_x,
                        .k_bending_z = k.bending_z,
                        .k_torsion = k.torsion,
                        .end_stiffness = condensed};
    lap("statics");
  }

  // One end moved 1 mm along and across, kept parallel; `end`: its first row in the boundary.
  void static_stress(const SparseMatrix& K, const std::vector<int>& boundary,
                     const SparseFactor& inner, const MatrixXd& condensed, int end) {
    StaticShapes shapes{.u = {}, .names = {"1 mm axial", "1 mm transverse x", "1 mm transverse z"}};
    MatrixXd at_boundary = MatrixXd::Zero(12, 3);
    const Eigen::Matrix3d parallel = condensed.block<3, 3>(end, end).inverse();
    for (const auto& [column, axis] : {std::pair{0, 1}, std::pair{1, 0}, std::pair{2, 2}})
      at_boundary.block<3, 1>(end, column) = 1e-3 / parallel(axis, axis) * parallel.col(axis);
    shapes.u = expand(system_.map, follow_boundary(K, boundary, inner, at_boundary));
    results_.stresses = static_stresses(shapes, built_.model);
  }

  void modes() {
    const Modes& asked = *case_.analyses.modes;
    const ModesRequest request{.count = asked.count, .band = asked.band, .proof = asked.proof};
    BaseFactor& factor = base();
    stage_("modes");
    const bool free_body = factor.sigma < 0;
    const std::optional<Response>& response = case_.analyses.response;
    std::optional<Excitations> excited;
    if (response) excited = excitations(*response, built_, system_, part_.free, factor);
    ModeSet set = find_modes(part_.K, part_.M, request, factor);
    for (const auto& [name, seconds] : set.timing) results_.timing[name] += seconds;
    watch_ = Stopwatch();
    stage_("labels");
    MatrixXd u = expand_free(set.Phi);
    std::vector<int> sensors;
    for (const BuiltSensor& s : built_.sensors) sensors.push_back(s.node);
    orient_modes(built_.model, sensors, set.lambda, set.Phi, u);
    const DampedModes damped = damped_modes(set, excited, u);
    add_modes(set, damped, free_body);
    verify(set);
    lap("labels");
    if (excited) respond(*response, damped, *excited);
    if (!case_.analyses.stress) return;
    stage_("stress");
    for (StressResult& s : dynamic_stresses(*case_.analyses.stress, response ? &*response : nullptr,
                                            built_.model, damped, excited ? &*excited : nullptr))
      results_.stresses.push_back(std::move(s));
    lap("stress");
  }

  // Over all DOFs from the free ones.
  MatrixXd expand_free(const MatrixXd& free) const {
    MatrixXd q = MatrixXd::Zero(system_.map.size(), free.cols());
    q(part_.free, Eigen::all) = free;
    return expand(system_.map, q);
  }

  DampedModes damped_modes(const ModeSet& set, const std::optional<Excitations>& excited,
                           const MatrixXd& u) const {
    const MatrixXd none(part_.K.rows(), 0);
    DampedModes modes{.basis = add_static_correction(part_.K, part_.M, set.lambda, set.Phi,
                                                     excited ? excited->static_solutions : none),
                      .u = {},
                      .zeta = {},
                      .eta = {}};
    const Eigen::Index pseudo = modes.basis.lambda.size() - set.lambda.size();
    modes.u.resize(u.rows(), u.cols() + pseudo);
    modes.u << u, expand_free(modes.basis.Phi.rightCols(pseudo));
    const ModalDamping damping = modal_damping(case_.analyses.damping, built_.model,
                                               modes.basis.lambda, modes.u, modes.basis.modes);
    modes.zeta = damping.zeta;
    modes.eta = damping.eta;
    return modes;
  }

  void respond(const Response& asked, const DampedModes& modes, const Excitations& excited) {
    stage_("response");
    results_.responses = responses(asked, built_, modes, excited);
    const double last = frequency(modes.basis.lambda[modes.basis.modes - 1]);
    if (last < asked.band[1])
      results_.warnings.push_back("the modes end at " + std::to_string(std::lround(last)) +
                                  " Hz: above, the response holds only their static part");
    lap("response");
  }

  void add_modes(const ModeSet& set, const DampedModes& damped, bool free_body) {
    const MatrixXd& u = damped.u;
    const FreeMass free = free_mass(built_.model, system_.map, part_.free, part_.M);
    const MatrixXd effective = effective_masses(free, part_.M, set.Phi);
    double elastic = 0; // lowest eigenvalue well above zero
    for (double lambda : set.lambda)
      if (elastic == 0 && lambda > 1e-6 * set.lambda.maxCoeff()) elastic = lambda;
    for (Eigen::Index i = 0; i < set.lambda.size(); ++i) {
      const Eigen::Matrix<double, 6, 1> m = effective.row(i).transpose();
      const bool rigid = free_body && set.lambda[i] < 1e-6 * elastic;
      const ModeLabel label =
          label_mode(built_.model, u.col(i), rigid, m.cwiseQuotient(free.total.cwiseMax(1e-300)));
      ModeResult mode{.frequency = frequency(set.lambda[i]),
                      .damping = damped.zeta[i] + damped.eta[i] / 2,
                      .effective_mass = {},
                      .shape = label.shape,
                      .direction = label.direction,
                      .order = label.order,
                      .harmonic = label.harmonic,
                      .residual = set.residual[i]};
      std::copy(m.begin(), m.end(), mode.effective_mass.begin());
      results_.modes.push_back(mode);
      Eigen::MatrixXd shape =
          Eigen::Map<const MatrixXd>(u.col(i).data(), 6, u.rows() / 6).transpose();
      results_.shapes.push_back(std::move(shape));
    }
    std::copy(free.total.begin(), free.total.end(), results_.free_mass.begin());
    const Eigen::RowVectorXd sum = effective.colwise().sum();
    std::copy(sum.begin(), sum.end(), results_.effective_mass_sum.begin());
  }

  void verify(const ModeSet& set) {
    results_.verification = {.made = set.proof.made,
                             .sigma_frequency = frequency(set.proof.sigma),
                             .inertia_count = set.proof.inertia_count,
                             .found = set.proof.found,
                             .max_residual = set.proof.max_residual,
                             .orthogonality = set.proof.orthogonality,
                             .passed = set.proof.passed,
                             .reason = set.proof.reason};
  }

  const Case& case_;
  const std::function<void(const std::string&)>& stage_;
  Stopwatch watch_;
  BuiltCase built_;
  System system_;
  FreeSystem part_;
  std::optional<BaseFactor> base_;
  Results results_;
};

} // namespace

Results run(const Case& data, const std::function<void(const std::string&)>& stage) {
  return Run(data, stage).results();
}

} // namespace plica

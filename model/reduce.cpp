#include "model/reduce.hpp"

#include "model/damping.hpp"
#include "model/input_error.hpp"
#include "model/route.hpp"
#include "reduction/craig_bampton.hpp"
#include "reduction/cyclic_modes.hpp"
#include "solve/parallel.hpp"
#include "solve/stopwatch.hpp"
#include "solve/strain_energy.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

using SymmetricView = std::variant<CyclicModel, std::string>;

[[noreturn]] void fail(const std::string& key, const std::string& wrong,
                       const std::string& allowed) {
  throw InputError({{.file = "", .line = 0, .key = key, .wrong = wrong, .allowed = allowed}});
}

Reduction reduce(const Model& model, const SymmetricView& view, const std::vector<int>& boundary,
                 double cutoff) {
  try {
    if (const auto* symmetric = std::get_if<CyclicModel>(&view))
      return craig_bampton(*symmetric, boundary, cutoff);
    return craig_bampton(model, boundary, cutoff);
  } catch (const std::invalid_argument& error) {
    fail("caps", error.what(), "caps whose reference nodes nothing else holds");
  }
}

VectorXd spectrum(const SparseMatrix& K, const SparseMatrix& M, double high) {
  BaseFactor base = factor_below_spectrum(K, M);
  return find_modes(K, M, {.band = {0, high}, .proof = false}, base).lambda;
}

// Of the harmonics that reach the boundary, pairs twice; first free, then held at the caps.
std::array<VectorXd, 2> symmetric_spectra(const CyclicModel& model, const std::vector<int>& caps,
                                          double high) {
  constexpr std::array families{Harmonic{0, false}, Harmonic{0, true}, Harmonic{1, false}};
  std::array<VectorXd, 2 * families.size()> lambda;
  in_parallel(int(lambda.size()), [&](int i) {
    const CyclicFamily f =
        cyclic_family(model, families[i / 2], i % 2 == 0 ? std::vector<int>{} : caps);
    lambda[i] = spectrum(f.K, f.M, high);
  });
  std::array<VectorXd, 2> spectra;
  for (int held : {0, 1}) {
    std::vector<double> values;
    for (std::size_t f = 0; f < families.size(); ++f)
      for (double x : lambda[2 * f + held])
        values.insert(values.end(), families[f].n == 1 ? 2 : 1, x);
    std::sort(values.begin(), values.end());
    spectra[held] = VectorXd::Map(values.data(), Eigen::Index(values.size()));
  }
  return spectra;
}

PartReference symmetric_reference(const CyclicModel& model, const std::vector<int>& caps,
                                  double high) {
  PartReference part;
  part.rigid_mass.setZero();
  for (const Harmonic& h :
       {Harmonic{0, false}, Harmonic{0, true}, Harmonic{1, false}, Harmonic{1, true}}) {
    const HarmonicSystem s = model.system(h);
    const MatrixXd r = model.rigid_motions(s);
    part.rigid_mass += r.transpose() * symmetric_product(s.M, r);
  }
  auto [free, fixed] = symmetric_spectra(model, caps, high);
  part.free_lambda = std::move(free);
  part.fixed_lambda = std::move(fixed);
  return part;
}

PartReference full_reference(const Model& model, const std::vector<int>& caps, double high) {
  const System system = assemble(model);
  PartReference part;
  const MatrixXd r = rigid_body_motions(model, system.map, Eigen::Vector3d::Zero());
  part.rigid_mass = r.transpose() * symmetric_product(system.M, r);
  std::vector<int> held;
  for (int node : caps)
    for (int dof = 6 * node; dof < 6 * node + 6; ++dof) held.push_back(system.map.independent[dof]);
  std::sort(held.begin(), held.end());
  const std::vector<int> inner = complement(system.map.size(), held);
  part.free_lambda = spectrum(system.K, system.M, high);
  part.fixed_lambda = spectrum(restrict_to(system.K, inner), restrict_to(system.M, inner), high);
  return part;
}

// Recovery rows, viscous damping of the modes, structural damping of the components.
void complete(Superelement& s, const Reduction& reduction, const BuiltCase& built,
              const Damping& damping) {
  const auto size = s.K.rows();
  const MatrixXd identity = MatrixXd::Identity(size, size);
  std::vector<int> nodes;
  for (const BuiltSensor& sensor : built.sensors) nodes.push_back(sensor.node);
  const MatrixXd rows = reduction.field_at(identity, nodes);
  for (std::size_t k = 0; k < built.sensors.size(); ++k)
    s.recovery.push_back({.name = built.sensors[k].name,
                          .place = built.model.mesh.nodes[nodes[k]],
                          .rows = rows.middleRows<6>(6 * Eigen::Index(k))});
  const VectorXd lambda = reduction.lambda;
  const ModalDamping modal =
      modal_damping({.modal = damping.modal, .ranges = damping.ranges}, built.model, lambda, {}, 0);
  if (modal.zeta.size() > 0 && modal.zeta.maxCoeff() > 0) {
    s.C = MatrixXd::Zero(size, size);
    s.C.diagonal().tail(lambda.size()) = 2 * modal.zeta.cwiseProduct(lambda.cwiseSqrt());
  }
  if (damping.loss_factors.empty()) return;
  s.D = MatrixXd::Zero(size, size);
  const std::vector<MatrixXd> parts = component_stiffness(built.model, reduction.field(identity));
  for (const LossFactor& loss : damping.loss_factors)
    for (std::size_t c = 0; c < parts.size(); ++c)
      if (built.model.components[c] == loss.of)
        s.D += loss.value / 2 * (parts[c] + parts[c].transpose());
}

} // namespace

ReducedCase reduce_case(const Case& given, double cutoff,
                        const std::function<void(const std::string&)>& stage) {
  Case data = given;
  data.mount.clear(); // whoever takes the superelement holds it
  if (data.caps.empty())
    fail("caps", "has none, and they are the boundary of a superelement", "give at least one cap");
  ReducedCase result;
  result.cutoff = cutoff > 0 ? cutoff : reduction_cutoff(data.analyses);
  Stopwatch watch;
  stage("mesh");
  const BuiltCase built = build(data);
  std::vector<int> caps;
  for (const Cap& cap : data.caps) caps.push_back(built.cap_nodes.at(cap.name));
  watch.lap(result.timing, "mesh");
  stage("symmetry");
  SymmetricView view = std::string("as the case asks");
  if (data.analyses.symmetry != Symmetry::off) view = cyclic_model(built.model);
  const auto* symmetric = std::get_if<CyclicModel>(&view);
  if (!symmetric && data.analyses.symmetry == Symmetry::required)
    fail("analyses.symmetry",
         "is required, but the part does not repeat around its axis: " +
             std::get<std::string>(view),
         "mend that, or let symmetry be automatic");
  result.route = symmetric
                     ? "rotational symmetry, " + std::to_string(symmetric->around()) + " sectors"
                     : "full mesh: " + std::get<std::string>(view);
  watch.lap(result.timing, "symmetry");
  stage("reduction");
  Reduction reduction = reduce(built.model, view, caps, result.cutoff);
  result.element = std::move(reduction.element);
  result.element.name = data.name;
  for (std::size_t i = 0; i < data.caps.size(); ++i)
    result.element.node_names[i] = data.caps[i].name;
  result.proved = reduction.proved;
  result.reason = reduction.reason;
  complete(result.element, reduction, built, data.analyses.damping);
  watch.lap(result.timing, "reduction");
  stage("certificate");
  PartReference part = symmetric ? symmetric_reference(*symmetric, caps, result.cutoff)
                                 : full_reference(built.model, caps, result.cutoff);
  part.grounded = !data.supports.empty();
  if (caps.size() == 2) { // by another way than the reduction
    std::map<std::string, double> ignored;
    const StageListener quiet = [](const std::string&) {};
    const auto route = symmetric ? cyclic_route(built, *symmetric, quiet, ignored)
                                 : full_route(built, "", quiet, ignored);
    part.static_stiffness =
        without_grounding(*route->end_stiffness({caps[0], caps[1]}), result.element.nodes);
  }
  result.certificate = certificate(result.element, part);
  watch.lap(result.timing, "certificate");
  result.peak_memory = peak_memory();
  return result;
}

} // namespace plica

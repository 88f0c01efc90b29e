#include "run/study/part_reference.hpp"

#include "reduction/cyclic_modes.hpp"
#include "solve/parallel.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

ModeSet modes_up_to(const SparseMatrix& K, const SparseMatrix& M, double high) {
  BaseFactor base = factor_below_spectrum(K, M);
  return find_modes(K, M, {.band = {0, high}, .proof = false}, base);
}

// Motion of the boundary nodes, six rows each, in modes of a harmonic with nothing held.
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
                           const std::vector<int>& caps, bool preloaded, double high) {
  const std::vector<int> first = preloaded ? std::vector<int>{caps.front()} : std::vector<int>{};
  constexpr std::array harmonics{Harmonic{0, false}, Harmonic{0, true}, Harmonic{1, false}};
  struct Mode {
    double lambda = 0;
    VectorXd motion;
  };
  std::array<std::vector<Mode>, 2 * harmonics.size()> found;
  in_parallel(int(found.size()), [&](int i) {
    const Harmonic& harmonic = harmonics[std::size_t(i / 2)];
    const bool free = i % 2 == 0;
    const CyclicFamily f = cyclic_family(model, harmonic, free ? first : caps);
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

PartReference symmetric_reference(const CyclicModel& model, const Boundary& boundary,
                                  bool preloaded, double high) {
  PartReference part;
  part.rigid_mass.setZero();
  for (const Harmonic& h :
       {Harmonic{0, false}, Harmonic{0, true}, Harmonic{1, false}, Harmonic{1, true}}) {
    const HarmonicSystem s = model.system(h);
    const MatrixXd r = model.rigid_motions(s);
    part.rigid_mass += r.transpose() * symmetric_product(s.M, r);
  }
  if (boundary.caps == static_cast<int>(boundary.nodes.size())) {
    add_symmetric_spectra(part, model, boundary.nodes, preloaded, high);
    return part;
  }
  // A node on the wall is reached by every harmonic; held, it would end the symmetry.
  const std::vector<int> first =
      preloaded ? std::vector<int>{boundary.nodes.front()} : std::vector<int>{};
  const CyclicModes modes = find_cyclic_modes(model, first, {.band = {0, high}, .proof = false});
  part.free_lambda.resize(Index(modes.modes.size()));
  for (std::size_t i = 0; i < modes.modes.size(); ++i)
    part.free_lambda[Index(i)] = modes.modes[i].lambda;
  return part;
}

PartReference full_reference(const Model& model, const Boundary& boundary, bool preloaded,
                             double high) {
  const System system = assemble(model);
  PartReference part;
  const MatrixXd r = rigid_body_motions(model, system.map, Eigen::Vector3d::Zero());
  part.rigid_mass = r.transpose() * symmetric_product(system.M, r);
  const std::vector<int> inner =
      complement(system.map.size(), node_dofs(system.map, boundary.nodes));
  part.fixed_lambda =
      modes_up_to(restrict_to(system.K, inner), restrict_to(system.M, inner), high).lambda;
  if (preloaded) {
    const std::vector<int> free =
        complement(system.map.size(), node_dofs(system.map, {boundary.nodes.front()}));
    part.free_lambda =
        modes_up_to(restrict_to(system.K, free), restrict_to(system.M, free), high).lambda;
    return part;
  }
  const ModeSet free = modes_up_to(system.K, system.M, high);
  part.free_lambda = free.lambda;
  part.free_motion.resize(6 * Index(boundary.nodes.size()), free.Phi.cols());
  for (std::size_t k = 0; k < boundary.nodes.size(); ++k)
    for (int d = 0; d < 6; ++d)
      part.free_motion.row(6 * Index(k) + d) =
          free.Phi.row(system.map.independent[6 * boundary.nodes[k] + d]);
  return part;
}

// Rigid motions about the origin that strain nothing: of a part that is held in some directions.
MatrixXd free_motions(const Model& model) {
  const System system = assemble(model);
  const MatrixXd r = rigid_body_motions(model, system.map, Eigen::Vector3d::Zero());
  const MatrixXd Kr = symmetric_product(system.K, r);
  const VectorXd size = (r.transpose() * symmetric_product(system.M, r)).diagonal();
  const VectorXd scale = size.cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const MatrixXd strain = scale.asDiagonal() * MatrixXd(r.transpose() * Kr) * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen((strain + strain.transpose()) / 2);
  constexpr double rounding = 1e-12; // of the stiffness over the mass of its stiffest DOF
  const double stiffest =
      system.K.diagonal().maxCoeff() / std::max(1e-300, system.M.diagonal().maxCoeff());
  int count = 0;
  while (count < 6 && eigen.eigenvalues()[count] < rounding * stiffest) ++count;
  return scale.asDiagonal() * eigen.eigenvectors().leftCols(count);
}

} // namespace

PartReference part_reference(const BuiltCase& built, const SymmetricView& view,
                             const Boundary& boundary, bool grounded, bool preloaded, double high) {
  const auto* symmetric = std::get_if<CyclicModel>(&view);
  PartReference part = symmetric ? symmetric_reference(*symmetric, boundary, preloaded, high)
                                 : full_reference(built.model, boundary, preloaded, high);
  part.grounded = grounded;
  if (grounded && !preloaded) part.free_motions = free_motions(built.model);
  return part;
}

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
  if (part.preload.size() > 0) { // a rigid rotation does raise forces
    part.static_stiffness = K;
    return;
  }
  // A superelement of superelements sums its parts in another order than the mesh does, and one
  // with further boundary nodes has its rounding spread over them before it is taken out.
  if ((nested || boundary.nodes.size() > 2) && !part.grounded)
    part.statics_known_to = grounding(K, places);
  part.static_stiffness = without_grounding(K, places);
}

} // namespace plica

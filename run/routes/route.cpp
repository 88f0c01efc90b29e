#include "run/routes/route.hpp"

#include "run/routes/built_reduced.hpp"
#include "run/routes/memory_need.hpp"
#include "run/stages.hpp"
#include "solve/effective_mass.hpp"
#include "solve/stopwatch.hpp"
#include "solve/strain_energy.hpp"
#include "words/input_error.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>

namespace plica {

namespace {

// "along y and about y": the rigid motions of the whole part that strain nothing; empty where it is
// a piece alone that moves.
std::string free_motion(const BuiltCase& built) {
  const System system = assemble(built.model);
  const std::vector<int> free =
      complement(system.map.size(), node_dofs(system.map, built.held_nodes));
  const SparseMatrix K = restrict_to(system.K, free), M = restrict_to(system.M, free);
  const FreeMass mass = free_mass(built.model, system.map, free, M);
  const Eigen::MatrixXd strain = mass.R.transpose() * symmetric_product(K, mass.R);
  const Eigen::VectorXd size = mass.total.cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(size.asDiagonal() * strain *
                                                             size.asDiagonal());
  const double scale = K.diagonal().maxCoeff() / std::max(M.diagonal().maxCoeff(), 1e-300);
  constexpr std::array names{"along x", "along y", "along z", "about x", "about y", "about z"};
  std::string text;
  for (Eigen::Index i = 0; i < 6; ++i) {
    if (eigen.eigenvalues()[i] > 1e-12 * scale) continue;
    Eigen::Index most = 0;
    eigen.eigenvectors().col(i).cwiseAbs().maxCoeff(&most);
    text += (text.empty() ? "" : ", ") + std::string(names[std::size_t(most)]);
  }
  return text;
}

} // namespace

void require_held(bool free_body, const BuiltCase& built) {
  if (!free_body) return;
  const std::string motion = free_motion(built);
  input_error(
      "analyses",
      (motion.empty()
           ? "nothing holds a piece of the part that nothing joins to the rest (joints with "
             "friction count as slipping)"
           : "nothing holds the part: it is free to move " + motion) +
          ", so it has no steady response",
      "a mount or supports that leave no rigid motion free");
}

Eigen::MatrixXd strain_energy(const ModalSolution& solution, const BuiltCase& built,
                              const std::vector<int>& columns) {
  if (solution.energy) return solution.energy(columns);
  return strain_energy(built.model, solution.u(Eigen::all, columns));
}

std::unique_ptr<Route> choose_route(const BuiltCase& built, const Analyses& analyses,
                                    const StageListener& stage, Timing& timing,
                                    const RouteSettings& settings) {
  const Symmetry symmetry = analyses.symmetry;
  if (analyses.reduction) {
    stage(stages::reduction);
    CutModel pieces = cut_between_caps(built, symmetry != Symmetry::off);
    require_memory_for(built, pieces, analyses, settings.seen != nullptr);
    return reduced_route(built, std::move(pieces), analyses, stage, timing, settings);
  }
  Stopwatch watch;
  if (symmetry != Symmetry::off) stage(stages::symmetry);
  SymmetricView view = symmetric_view(built.model, symmetry);
  if (symmetry != Symmetry::off) watch.lap(timing, "symmetry");
  require_memory_for(built, analyses, view);
  if (auto* model = std::get_if<CyclicModel>(&view))
    return cyclic_route(built, std::move(*model), stage, timing);
  return full_route(built, std::get<std::string>(view), stage, timing);
}

} // namespace plica

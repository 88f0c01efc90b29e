#include "diagnose/predict/loose_motions.hpp"

#include "solve/assembly.hpp"
#include "solve/modes.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace plica {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd loose_motions(const Model& model) {
  const System system = assemble(model);
  const MatrixXd R = rigid_body_motions(model, system.map, {0, 0, 0});
  const MatrixXd strain = R.transpose() * symmetric_product(system.K, R);
  const VectorXd mass = (R.transpose() * symmetric_product(system.M, R)).diagonal();
  const VectorXd size = mass.cwiseMax(1e-12 * mass.maxCoeff()).cwiseSqrt();
  const auto scaled = size.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(scaled * strain * scaled);
  constexpr double rounding = 1e-10; // of the stiffness against the motion that strains most
  std::vector<Index> found;
  for (Index i = 0; i < 6; ++i)
    if (eigen.eigenvalues()[i] <= rounding * eigen.eigenvalues()[5]) found.push_back(i);
  return scaled * eigen.eigenvectors()(Eigen::all, found);
}

Model on_a_soft_spring(Model model, Index loose) {
  const System system = assemble(model);
  BaseFactor base = factor_below_spectrum(system.K, system.M);
  const ModeSet set =
      find_modes(system.K, system.M, {.count = int(loose) + 1, .band = {}, .proof = false}, base);
  const MatrixXd R = rigid_body_motions(model, system.map, {0, 0, 0});
  const VectorXd mass = (R.transpose() * symmetric_product(system.M, R)).diagonal();
  constexpr double softer = 1e-6;
  const double k = softer * set.lambda[loose];
  BushingElement spring;
  spring.node1 =
      model.beams.empty() ? model.mesh.quads.front().nodes[0] : model.beams.front().node1;
  for (int d = 0; d < 6; ++d)
    spring.bushing.law(d, d) = k * (d < 3 ? mass.head(3) : mass.tail(3)).maxCoeff();
  model.bushings.push_back(spring);
  return model;
}

} // namespace plica

#include "diagnose/predict/loose_motions.hpp"

#include "solve/assembly.hpp"
#include "solve/modes.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace plica {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Vectors of a symmetric matrix whose values are at most this, or above it.
MatrixXd vectors(const MatrixXd& A, double limit, bool below) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(A);
  std::vector<Index> found;
  for (Index i = 0; i < A.rows(); ++i)
    if ((eigen.eigenvalues()[i] <= limit) == below) found.push_back(i);
  return eigen.eigenvectors()(Eigen::all, found);
}

double largest_value(const MatrixXd& A) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(A, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

} // namespace

MatrixXd loose_motions(const Model& model) {
  const System system = assemble(model);
  const MatrixXd R = rigid_body_motions(model, system.map, {0, 0, 0});
  const MatrixXd mass = R.transpose() * symmetric_product(system.M, R);
  const VectorXd most = mass.diagonal();
  const VectorXd size = most.cwiseMax(1e-12 * most.maxCoeff()).cwiseSqrt();
  const auto scaled = size.cwiseInverse().asDiagonal();
  const MatrixXd strain = scaled * (R.transpose() * symmetric_product(system.K, R)) * scaled;
  // Strain of motions in which every degree of freedom moved alone: what rounding is measured by.
  const VectorXd alone = R.cwiseAbs2().transpose() * VectorXd(system.K.diagonal());
  constexpr double small = 1e-10, rounding = 1e-13;
  const double nothing = std::max(small * largest_value(strain),
                                  rounding * (alone.array() / size.array().square()).maxCoeff());
  // What supports take away everywhere moves no mass, and is not loose.
  const MatrixXd moving = vectors(scaled * mass * scaled, small, false);
  return scaled * (moving * vectors(moving.transpose() * strain * moving, nothing, true));
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

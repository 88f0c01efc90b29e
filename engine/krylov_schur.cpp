#include "engine/krylov_schur.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

using OwnedEPS = Owned<EPS, EPSDestroy>;

// The solves of SLEPc go through our factor, which it need not know how to make.
PetscErrorCode apply_factor(PC pc, Vec b, Vec x) {
  void* factor = nullptr;
  PetscCall(PCShellGetContext(pc, &factor));
  static_cast<const MumpsFactor*>(factor)->solve(b, x);
  return 0;
}

Eigen::VectorXd own_rows(Vec v) {
  PetscInt rows = 0;
  const PetscScalar* values = nullptr;
  petsc(VecGetLocalSize(v, &rows));
  petsc(VecGetArrayRead(v, &values));
  const Eigen::VectorXd own = Eigen::Map<const Eigen::VectorXd>(values, rows);
  petsc(VecRestoreArrayRead(v, &values));
  return own;
}

void set_up_transform(EPS eps, const MumpsFactor& factor, double sigma) {
  ST st = nullptr;
  KSP ksp = nullptr;
  PC pc = nullptr;
  petsc(EPSGetST(eps, &st));
  petsc(STSetType(st, STSINVERT));
  petsc(STSetMatMode(st, ST_MATMODE_SHELL)); // K - sigma M is formed where it is factored
  petsc(STSetShift(st, sigma));
  petsc(EPSSetTarget(eps, sigma));
  petsc(STGetKSP(st, &ksp));
  petsc(KSPSetType(ksp, KSPPREONLY));
  petsc(KSPGetPC(ksp, &pc));
  petsc(PCSetType(pc, PCSHELL));
  petsc(PCShellSetContext(pc, const_cast<MumpsFactor*>(&factor)));
  petsc(PCShellSetApply(pc, apply_factor));
}

void start_from(EPS eps, const DistributedMatrix& K, const DistributedMatrix& M,
                const MumpsFactor& factor, unsigned seed) {
  OwnedVec start;
  petsc(MatCreateVecs(K.mat(), start.fill(), nullptr));
  const MatrixXd x = factor.solve(M * start_vector(K, seed)); // in the range of the operator
  PetscScalar* to = nullptr;
  petsc(VecGetArray(start, &to));
  std::copy(x.col(0).begin(), x.col(0).end(), to);
  petsc(VecRestoreArray(start, &to));
  Vec first = start;
  petsc(EPSSetInitialSpace(eps, 1, &first));
}

} // namespace

MatrixXd start_vector(const DistributedMatrix& K, unsigned seed) {
  MatrixXd x(K.own_rows(), 1);
  for (Index i = 0; i < x.rows(); ++i) { // splitmix64 of the number of the unknown
    std::uint64_t z = (std::uint64_t(K.first() + i) << 8) + seed;
    z = (z + 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    x(i, 0) = double((z ^ (z >> 31)) >> 11) / double(std::uint64_t(1) << 53) - 0.5;
  }
  return x;
}

EigenColumns krylov_schur(const DistributedMatrix& K, const DistributedMatrix& M,
                          const MumpsFactor& factor, double sigma, int count, unsigned seed,
                          const Ranks& ranks) {
  OwnedEPS eps;
  petsc(EPSCreate(ranks.comm(), eps.fill()));
  petsc(EPSSetOperators(eps, K.mat(), M.mat()));
  petsc(EPSSetProblemType(eps, EPS_GHEP));
  petsc(EPSSetType(eps, EPSKRYLOVSCHUR));
  petsc(EPSSetWhichEigenpairs(eps, EPS_TARGET_MAGNITUDE));
  petsc(EPSSetPurify(eps, PETSC_TRUE)); // the mass may be singular
  const int subspace = std::min(K.size(), 2 * count + 24);
  petsc(EPSSetDimensions(eps, count, subspace, PETSC_DEFAULT));
  petsc(EPSSetTolerances(eps, 1e-11, 200));
  set_up_transform(eps, factor, sigma);
  start_from(eps, K, M, factor, seed);
  petsc(EPSSolve(eps));

  EigenColumns found = eigen_columns(eps, K, M, count, ranks);
  found.converged = found.converged && found.lambda.size() == count;
  if (!found.converged)
    found.reason = "SLEPc: " + std::to_string(found.lambda.size()) + " of " +
                   std::to_string(count) + " modes converged";
  return found;
}

EigenColumns eigen_columns(EPS eps, const DistributedMatrix& K, const DistributedMatrix& M,
                           int most, const Ranks& ranks) {
  EigenColumns found;
  EPSConvergedReason why{};
  PetscInt converged = 0;
  petsc(EPSGetConvergedReason(eps, &why));
  petsc(EPSGetConverged(eps, &converged));
  found.converged = why > 0;
  if (!found.converged)
    found.reason = "SLEPc did not converge (" + std::string(EPSConvergedReasons[why]) + ")";
  OwnedVec x;
  petsc(MatCreateVecs(K.mat(), x.fill(), nullptr));
  const int kept = most < 0 ? converged : std::min<int>(converged, most);
  Eigen::VectorXd lambda(kept);
  MatrixXd Phi(K.own_rows(), kept);
  for (int i = 0; i < kept; ++i) {
    PetscScalar value = 0;
    petsc(EPSGetEigenpair(eps, i, &value, nullptr, x, nullptr));
    lambda[i] = value;
    Phi.col(i) = own_rows(x);
  }
  std::vector<int> order(std::size_t(kept), 0);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return lambda[a] < lambda[b]; });
  found.lambda = lambda(order);
  found.Phi = Phi(Eigen::all, order);
  const MatrixXd MPhi = M * found.Phi;
  const MatrixXd mass = ranks.sum(MatrixXd(found.Phi.cwiseProduct(MPhi).colwise().sum()));
  for (int i = 0; i < kept; ++i) found.Phi.col(i) /= std::sqrt(mass(0, i));
  return found;
}

} // namespace plica

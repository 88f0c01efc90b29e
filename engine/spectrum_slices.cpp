#include "engine/spectrum_slices.hpp"

#include <slepceps.h>

namespace plica {
namespace {

using OwnedEPS = Owned<EPS, EPSDestroy>;

constexpr const char* prefix = "slices_";

// SLEPc makes the factors of its shifts itself; MUMPS' options reach them by PETSc's table.
void set_mumps(int workspace) {
  const std::string before = std::string("-") + prefix + "st_mat_mumps_icntl_";
  for (const auto& [number, value] : {std::pair{7, 7}, {8, 77}, {13, 1}, {14, workspace}, {24, 1}})
    petsc(PetscOptionsSetValue(nullptr, (before + std::to_string(number)).c_str(),
                               std::to_string(value).c_str()));
}

OwnedEPS slicing(const DistributedMatrix& K, const DistributedMatrix& M, double low, double high,
                 const Ranks& ranks) {
  OwnedEPS eps;
  petsc(EPSCreate(ranks.comm(), eps.fill()));
  petsc(EPSSetOptionsPrefix(eps, prefix));
  petsc(EPSSetOperators(eps, K.mat(), M.mat()));
  petsc(EPSSetProblemType(eps, EPS_GHEP));
  petsc(EPSSetType(eps, EPSKRYLOVSCHUR));
  petsc(EPSSetWhichEigenpairs(eps, EPS_ALL));
  petsc(EPSSetInterval(eps, low, high));
  petsc(EPSSetPurify(eps, PETSC_TRUE));
  petsc(EPSSetTolerances(eps, 1e-11, 200));
  petsc(EPSKrylovSchurSetDetectZeros(eps, PETSC_TRUE));
  ST st = nullptr;
  KSP ksp = nullptr;
  PC pc = nullptr;
  petsc(EPSGetST(eps, &st));
  petsc(STSetType(st, STSINVERT));
  petsc(EPSKrylovSchurGetKSP(eps, &ksp));
  petsc(KSPSetType(ksp, KSPPREONLY));
  petsc(KSPGetPC(ksp, &pc));
  petsc(PCSetType(pc, PCCHOLESKY));
  petsc(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
  return eps;
}

Mat factor_of(EPS eps) {
  KSP ksp = nullptr;
  PC pc = nullptr;
  Mat factor = nullptr;
  petsc(EPSKrylovSchurGetKSP(eps, &ksp));
  petsc(KSPGetPC(ksp, &pc));
  petsc(PCFactorGetMatrix(pc, &factor));
  return factor;
}

// Without these a count is none: options that did not arrive would be left out in silence.
void require_options(Mat factor) {
  for (const auto& [number, wanted] : {std::pair{13, 1}, {24, 1}}) {
    PetscInt value = 0;
    petsc(MatMumpsGetIcntl(factor, number, &value));
    if (value != wanted)
      end_all("MUMPS: option ICNTL(" + std::to_string(number) + ") of the slices did not arrive");
  }
}

void note_inertias(EPS eps, const MumpsSettings& settings) {
  PetscInt shifts = 0, *counts = nullptr;
  PetscReal* at = nullptr;
  petsc(EPSKrylovSchurGetInertias(eps, &shifts, &at, &counts));
  std::string words = "slices: " + std::to_string(shifts) + " shifts, eigenvalues below them:";
  for (PetscInt i = 0; i < shifts; ++i) words += " " + std::to_string(counts[i]);
  settings.note(words);
  petsc(PetscFree(at));
  petsc(PetscFree(counts));
}

} // namespace

EigenColumns spectrum_slices(const DistributedMatrix& K, const DistributedMatrix& M, double low,
                             double high, const Ranks& ranks, const MumpsSettings& settings) {
  // A matrix that is marked as definite would not be pivoted.
  petsc(MatSetOption(K.mat(), MAT_SPD, PETSC_FALSE));
  petsc(MatSetOption(K.mat(), MAT_SYMMETRIC, PETSC_TRUE));
  int workspace = settings.workspace;
  for (int retry = 0;; ++retry) {
    set_mumps(workspace);
    const OwnedEPS eps = slicing(K, M, low, high, ranks);
    if (const PetscErrorCode code = EPSSolve(eps); code != 0) {
      PetscInt error = 0;
      const Mat factor = factor_of(eps);
      if (factor) MatMumpsGetInfog(factor, 1, &error);
      if (!lacks_workspace(error) || retry == settings.retries) petsc(code);
      settings.note("MUMPS: error " + std::to_string(error) + " in a slice with " +
                    std::to_string(workspace) +
                    " % of workspace; all slices again with twice that");
      workspace = std::max(2 * workspace, 40);
      continue;
    }
    require_options(factor_of(eps));
    note_inertias(eps, settings);
    return eigen_columns(eps, K, M, -1, ranks);
  }
}

} // namespace plica

#include "engine/mumps_factor.hpp"

#include <array>
#include <cmath>

namespace plica {
namespace {

using Eigen::MatrixXd;

std::string ordering_name(int infog7) {
  constexpr std::array names{"AMD", "given", "AMF", "SCOTCH", "PORD", "METIS", "QAMD"};
  return infog7 >= 0 && infog7 < int(names.size()) ? names[std::size_t(infog7)]
                                                   : "ordering " + std::to_string(infog7);
}

bool is_memory(int infog1) {
  return infog1 == -13 || infog1 == -19 || infog1 == -7 || infog1 == -22;
}

} // namespace

bool lacks_workspace(int infog1) {
  return infog1 == -8 || infog1 == -9 || infog1 == -14 || infog1 == -15 || infog1 == -17 ||
         infog1 == -20;
}

std::string mumps_error(int info1, int info2, int workspace) {
  const std::string what =
      "MUMPS: error " + std::to_string(info1) + " (" + std::to_string(info2) + ")";
  if (lacks_workspace(info1))
    return what + ": its workspace is too small, also with " + std::to_string(workspace) +
           " % more than it foresaw (--workspace)";
  if (is_memory(info1))
    return what + ": memory is short on a rank; take more nodes, or fewer ranks on each";
  if (info1 == -10 || info1 == -6) return what + ": the matrix is singular";
  return what;
}

MumpsFactor::MumpsFactor(const DistributedMatrix& A, Definiteness kind, const Ranks& ranks,
                         MumpsSettings settings)
    : ranks_(&ranks), settings_(std::move(settings)), rows_(A.size()) {
  petsc(MatSetOption(A.mat(), MAT_SPD, kind == Definiteness::definite ? PETSC_TRUE : PETSC_FALSE));
  if (kind == Definiteness::indefinite) petsc(MatSetOption(A.mat(), MAT_SYMMETRIC, PETSC_TRUE));
  report_.workspace = settings_.workspace;
  factorise(A);
}

void MumpsFactor::set_options() {
  for (const auto& [number, value] : {std::pair{28, 1},        // one rank orders ...
                                      {7, settings_.ordering}, // ... in this way
                                      {8, 77},                 // scaled as it finds best
                                      {13, 1},                 // the root too is counted
                                      {14, report_.workspace},
                                      {22, 0}, // in memory
                                      {23, settings_.megabytes},
                                      {24, 1},  // null pivots are counted
                                      {10, 0}}) // no refinement of its own
    petsc(MatMumpsSetIcntl(factor_, number, value));
}

// PETSc makes no second attempt on a factor that failed, whatever is set: each begins anew.
void MumpsFactor::factorise(const DistributedMatrix& A) {
  MatFactorInfo options;
  petsc(MatFactorInfoInitialize(&options));
  for (;;) {
    petsc(MatGetFactor(A.mat(), MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, factor_.fill()));
    set_options();
    petsc(MatCholeskyFactorSymbolic(factor_, A.mat(), nullptr, &options));
    if (info(1) >= 0) petsc(MatCholeskyFactorNumeric(factor_, A.mat(), &options));
    const int error = info(1);
    if (error >= 0) break;
    const bool limited = error == -19 && settings_.megabytes > 0;
    if ((!lacks_workspace(error) && !limited) || report_.retries == settings_.retries)
      end_all(mumps_error(error, info(2), report_.workspace), is_memory(error) ? 4 : 3);
    ++report_.retries;
    const int more = std::max(2 * report_.workspace, 40);
    settings_.note("MUMPS: error " + std::to_string(error) + ", workspace too small with " +
                   std::to_string(report_.workspace) + " % beyond the estimate" +
                   (limited ? " and " + std::to_string(settings_.megabytes) + " MB a rank" : "") +
                   "; once more with " +
                   (limited ? std::to_string(2 * settings_.megabytes) + " MB and " : "") +
                   std::to_string(more) + " %");
    report_.workspace = more;
    settings_.megabytes *= 2;
  }
  int positive = 0;
  petsc(MatGetInertia(factor_, &negative_, &null_, &positive));
  if (negative_ + null_ + positive != rows_)
    end_all("MUMPS: the pivots it counts are not as many as the unknowns");
  report_.ordering = ordering_name(info(7));
  const int entries = info(29);
  report_.entries = entries < 0 ? -1e6 * double(entries) : double(entries);
  petsc(MatMumpsGetRinfog(factor_, 3, &report_.flops));
  report_.delayed = info(13);
  report_.megabytes = info(21);
  report_.megabytes_sum = info(22);
}

int MumpsFactor::info(int number) const {
  PetscInt value = 0;
  petsc(MatMumpsGetInfog(factor_, number, &value));
  return value;
}

MatrixXd MumpsFactor::solve(const MatrixXd& b) const {
  MatrixXd right = b, x(b.rows(), b.cols());
  OwnedMat B, X;
  const auto wrap = [&](MatrixXd& block, OwnedMat& into) {
    petsc(MatCreateDense(ranks_->comm(), PetscInt(block.rows()), PETSC_DECIDE, rows_,
                         PetscInt(block.cols()), block.data(), into.fill()));
  };
  if (b.cols() == 0) return x;
  wrap(right, B);
  wrap(x, X);
  petsc(MatMatSolve(factor_, B, X));
  return x;
}

void MumpsFactor::solve(Vec b, Vec x) const {
  petsc(MatSolve(factor_, b, x));
}

} // namespace plica

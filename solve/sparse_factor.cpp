// Products of long matrices through BLAS.
#define EIGEN_USE_BLAS
#include "solve/sparse_factor.hpp"

#include "solve/cholmod_indices.hpp"
#include "solve/parallel.hpp"

#include <algorithm>
#include <cstring>
#include <mutex>
#include <omp.h>
#include <stdexcept>
#include <sys/resource.h>
#include <vector>

// OpenBLAS has its own threads; with another BLAS the symbol is absent and BLAS keeps its default.
extern "C" void openblas_set_num_threads(int) __attribute__((weak));

namespace plica {

namespace {

// CHOLMOD's state, quiet.
void start(const CholmodFunctions& cholmod, cholmod_common& common) {
  cholmod.start(&common);
  common.print = 0;
  common.error_handler = nullptr;
}

// What a solve needs of its own beside others with the same factor.
struct Workspace {
  const CholmodFunctions& cholmod;
  cholmod_common common{};
  cholmod_dense *x = nullptr, *y = nullptr, *e = nullptr; // owned

  explicit Workspace(const CholmodFunctions& functions) : cholmod(functions) {
    start(cholmod, common);
  }
  ~Workspace() {
    cholmod.free_dense(&x, &common);
    cholmod.free_dense(&y, &common);
    cholmod.free_dense(&e, &common);
    cholmod.finish(&common);
  }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;
};

} // namespace

struct SparseFactor::Impl {
  const CholmodFunctions& cholmod;
  mutable cholmod_common common{};
  cholmod_factor* factor = nullptr; // owned
  mutable Workspace one_vector;     // of solves that do not allocate
  Eigen::VectorXi order;            // row of the factor -> row of A
  Factorisation kind;
  int rows = 0;

  Impl(Factorisation k, int n, IndexWidth width)
      : cholmod(cholmod_functions(width == IndexWidth::wide || outgrows_narrow(n))),
        one_vector(cholmod), kind(k), rows(n) {
    start(cholmod, common);
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_METIS;
    common.postorder = 1;
    common.supernodal = k == Factorisation::cholesky ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
    common.final_ll = k == Factorisation::cholesky;
    common.quick_return_if_not_posdef = 1;
  }
  ~Impl() {
    cholmod.free_factor(&factor, &common);
    cholmod.finish(&common);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void solve(int system, const double* b, Eigen::Index columns, double* result,
             Workspace& own) const;
  Eigen::MatrixXd solve(int system, const Eigen::MatrixXd& b) const; // in groups, on all cores
};

namespace {

// CHOLMOD's own OpenMP loops ask for four threads whatever the machine has, and wake them for each
// small supernode. Inside this scope they run in one; BLAS keeps its threads.
class OneOpenMpThread {
public:
  OneOpenMpThread() : levels_(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }
  ~OneOpenMpThread() { omp_set_max_active_levels(levels_); }
  OneOpenMpThread(const OneOpenMpThread&) = delete;
  OneOpenMpThread& operator=(const OneOpenMpThread&) = delete;

private:
  int levels_;
};

cholmod_dense view(const double* b, Eigen::Index rows, Eigen::Index columns) {
  cholmod_dense v{};
  v.nrow = v.d = static_cast<std::size_t>(rows);
  v.ncol = static_cast<std::size_t>(columns);
  v.nzmax = v.nrow * v.ncol;
  v.x = const_cast<double*>(b);
  v.xtype = CHOLMOD_REAL;
  v.dtype = CHOLMOD_DOUBLE;
  return v;
}

std::string words(int status) {
  switch (status) {
  case CHOLMOD_OUT_OF_MEMORY:
    return "not enough memory";
  case CHOLMOD_TOO_LARGE:
    return "the factor has more entries than its numbers can count";
  case CHOLMOD_NOT_INSTALLED:
    return "CHOLMOD was built without this method";
  case CHOLMOD_INVALID:
    return "the matrix is not valid";
  default:
    return "CHOLMOD status " + std::to_string(status);
  }
}

} // namespace

void SparseFactor::Impl::solve(int system, const double* b, Eigen::Index columns, double* result,
                               Workspace& own) const {
  cholmod_dense B = view(b, rows, columns);
  if (cholmod.solve2(system, factor, &B, nullptr, &own.x, nullptr, &own.y, &own.e, &own.common) ==
      0)
    throw std::runtime_error("sparse solve failed: " + words(own.common.status));
  std::memcpy(result, own.x->x, sizeof(double) * B.nrow * B.ncol);
}

Eigen::MatrixXd SparseFactor::Impl::solve(int system, const Eigen::MatrixXd& b) const {
  constexpr Eigen::Index narrowest = 4, widest = 16; // of a group
  Eigen::MatrixXd x(b.rows(), b.cols());
  if (x.size() == 0) return x;
  const Eigen::Index width = std::clamp((b.cols() + 1) / 2, narrowest, widest);
  const auto groups = static_cast<int>((b.cols() + width - 1) / width);
  in_parallel(groups, [&](int g) {
    const Eigen::Index first = g * width, columns = std::min(width, b.cols() - first);
    Workspace own(cholmod); // whoever solves with this factor at the same time has another
    solve(system, b.col(first).data(), columns, x.col(first).data(), own);
  });
  return x;
}

SparseFactor::SparseFactor(const SparseMatrix& pattern, Factorisation kind, IndexWidth width)
    : impl_(std::make_unique<Impl>(kind, static_cast<int>(pattern.rows()), width)) {
  if (impl_->rows == 0) return;
  // METIS draws from rand(), which threads share: one analysis at a time, or the order, and with it
  // the last digits of all that follows, differs from run to run.
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  CholmodView A(pattern, impl_->cholmod.index_type);
  impl_->factor = impl_->cholmod.analyze(A.get(), &impl_->common);
  if (impl_->factor == nullptr)
    throw std::runtime_error("sparse analysis failed: " + words(impl_->common.status));
  with_indices(impl_->factor->Perm, impl_->cholmod.index_type, [&](const auto* rows) {
    impl_->order.resize(impl_->rows);
    std::transform(rows, rows + impl_->rows, impl_->order.data(),
                   [](auto row) { return static_cast<int>(row); });
  });
}

SparseFactor::~SparseFactor() = default;
SparseFactor::SparseFactor(SparseFactor&&) noexcept = default;
SparseFactor& SparseFactor::operator=(SparseFactor&&) noexcept = default;

FactorStatus SparseFactor::factorise(const SparseMatrix& lower) {
  if (impl_->rows == 0) return {.ok = true, .failed_column = -1, .reason = ""};
  const OneOpenMpThread scope;
  CholmodView A(lower, impl_->cholmod.index_type);
  cholmod_common& c = impl_->common;
  c.status = CHOLMOD_OK;
  const bool done = impl_->cholmod.factorize(A.get(), impl_->factor, &c) != 0;
  if (!done || c.status < CHOLMOD_OK)
    throw std::runtime_error("sparse factorisation failed: " + words(c.status));
  const bool cut_short = impl_->factor->minor < impl_->factor->n;
  if (!cut_short && c.status == CHOLMOD_OK) return {.ok = true, .failed_column = -1, .reason = ""};
  const int column = cut_short ? order()[Eigen::Index(impl_->factor->minor)] : -1;
  return {.ok = false,
          .failed_column = column,
          .reason = impl_->kind == Factorisation::cholesky ? "the matrix is not positive definite"
                                                           : "a pivot is zero"};
}

Eigen::MatrixXd SparseFactor::solve(const Eigen::MatrixXd& b) const {
  return impl_->solve(CHOLMOD_A, b);
}

Eigen::MatrixXd SparseFactor::quadratic_form(const SparseMatrix& b) const {
  Eigen::VectorXi place(b.rows()); // of a row in the order of the factor
  for (int i = 0; i < impl_->rows; ++i) place[order()[i]] = i;
  Eigen::MatrixXd permuted = Eigen::MatrixXd::Zero(b.rows(), b.cols());
  for (int j = 0; j < b.outerSize(); ++j)
    for (SparseMatrix::InnerIterator it(b, j); it; ++it) permuted(place[it.row()], j) = it.value();
  const Eigen::MatrixXd Y = solve_lower(permuted);
  Eigen::MatrixXd form = Eigen::MatrixXd::Zero(b.cols(), b.cols());
  form.selfadjointView<Eigen::Lower>().rankUpdate(Y.transpose());
  return form.selfadjointView<Eigen::Lower>();
}

Eigen::MatrixXd SparseFactor::solve_lower(const Eigen::MatrixXd& b) const {
  return impl_->solve(CHOLMOD_L, b);
}

Eigen::MatrixXd SparseFactor::solve_upper(const Eigen::MatrixXd& b) const {
  return impl_->solve(CHOLMOD_Lt, b);
}

void SparseFactor::solve_lower(const double* b, double* x) const {
  impl_->solve(CHOLMOD_L, b, 1, x, impl_->one_vector);
}

void SparseFactor::solve_upper(const double* b, double* x) const {
  impl_->solve(CHOLMOD_Lt, b, 1, x, impl_->one_vector);
}

const Eigen::VectorXi& SparseFactor::order() const {
  return impl_->order;
}

int SparseFactor::rows() const {
  return impl_->rows;
}

int SparseFactor::negative_pivots() const {
  const cholmod_factor& L = *impl_->factor;
  const double* x = static_cast<const double*>(L.x);
  return with_indices(L.p, impl_->cholmod.index_type, [&](const auto* first) {
    int count = 0;
    for (std::size_t j = 0; j < L.n; ++j) count += x[first[j]] < 0;
    return count;
  });
}

double SparseFactor::factor_entries() const {
  return impl_->common.lnz;
}

void set_threads(int threads) {
  omp_set_num_threads(threads > 0 ? threads : omp_get_num_procs());
  Eigen::setNbThreads(1); // its products wait for each other by spinning
  set_blas_threads(1);
}

void set_blas_threads(int threads) {
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(threads);
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024. * double(usage.ru_maxrss);
}

} // namespace plica

// CHOLMOD twice: with 32-bit and with 64-bit numbers of rows and entries, behind one table.
#pragma once

#include "solve/assembly.hpp"

#include <cholmod.h>
#include <type_traits>
#include <vector>

namespace plica {

struct CholmodFunctions {
  int index_type;
  decltype(&cholmod_start) start;
  decltype(&cholmod_finish) finish;
  decltype(&cholmod_analyze) analyze;
  decltype(&cholmod_factorize) factorize;
  decltype(&cholmod_solve2) solve2;
  decltype(&cholmod_free_dense) free_dense;
  decltype(&cholmod_free_factor) free_factor;
};

inline constexpr CholmodFunctions cholmod_narrow{
    CHOLMOD_INT,       cholmod_start,  cholmod_finish,     cholmod_analyze,
    cholmod_factorize, cholmod_solve2, cholmod_free_dense, cholmod_free_factor,
};
inline constexpr CholmodFunctions cholmod_wide{
    CHOLMOD_LONG,        cholmod_l_start,  cholmod_l_finish,     cholmod_l_analyze,
    cholmod_l_factorize, cholmod_l_solve2, cholmod_l_free_dense, cholmod_l_free_factor,
};

// The entries of a factor begin to outgrow 32 bits.
inline bool outgrows_narrow(Eigen::Index rows) {
  constexpr Eigen::Index many = 4000000;
  return rows >= many;
}

inline const CholmodFunctions& cholmod_functions(bool wide) {
  return wide ? cholmod_wide : cholmod_narrow;
}

// An Eigen matrix (lower triangle) as CHOLMOD sees it, which does not change it. Must not outlive
// the matrix.
class CholmodView {
public:
  CholmodView(const SparseMatrix& A, int index_type) {
    view_.nrow = static_cast<std::size_t>(A.rows());
    view_.ncol = static_cast<std::size_t>(A.cols());
    view_.nzmax = static_cast<std::size_t>(A.nonZeros());
    view_.p = const_cast<int*>(A.outerIndexPtr());
    view_.i = const_cast<int*>(A.innerIndexPtr());
    if (index_type == CHOLMOD_LONG) {
      begins_.assign(A.outerIndexPtr(), A.outerIndexPtr() + A.cols() + 1);
      rows_.assign(A.innerIndexPtr(), A.innerIndexPtr() + A.nonZeros());
      view_.p = begins_.data();
      view_.i = rows_.data();
    }
    view_.x = const_cast<double*>(A.valuePtr());
    view_.stype = -1;
    view_.itype = index_type;
    view_.xtype = CHOLMOD_REAL;
    view_.dtype = CHOLMOD_DOUBLE;
    view_.sorted = 1;
    view_.packed = 1;
  }
  CholmodView(const CholmodView&) = delete;
  CholmodView& operator=(const CholmodView&) = delete;

  cholmod_sparse* get() { return &view_; }

private:
  cholmod_sparse view_{};
  std::vector<SuiteSparse_long> begins_, rows_;
};

// Analyses in a given order of the rows; null when that failed. As cholmod_analyze_p().
inline cholmod_factor* analyze_in_order(CholmodView& A, const Eigen::VectorXi& order,
                                        const CholmodFunctions& functions, cholmod_common& common) {
  if (functions.index_type == CHOLMOD_INT)
    return cholmod_analyze_p(A.get(), const_cast<int*>(order.data()), nullptr, 0, &common);
  std::vector<SuiteSparse_long> wide(order.begin(), order.end());
  return cholmod_l_analyze_p(A.get(), wide.data(), nullptr, 0, &common);
}

// Calls f with the numbers behind a pointer of CHOLMOD's as what they are.
template <class F> auto with_indices(const void* numbers, int index_type, F&& f) {
  return index_type == CHOLMOD_LONG ? f(static_cast<const SuiteSparse_long*>(numbers))
                                    : f(static_cast<const int*>(numbers));
}

} // namespace plica

// Independent pieces of work on all cores.
#pragma once

#include <exception>
#include <omp.h>

namespace plica {

// Runs f(i) for i in [0, count) on all cores; the first error is thrown again.
template <class F> void in_parallel(int count, F&& f) {
  std::exception_ptr error;
#pragma omp parallel for schedule(dynamic)
  for (int i = 0; i < count; ++i) {
    try {
      f(i);
    } catch (...) {
#pragma omp critical(plica_parallel_error)
      error = std::current_exception();
    }
  }
  if (error) std::rethrow_exception(error);
}

// The calling thread works alone in what it runs from now on: for threads that are parallel
// themselves.
inline void work_alone() {
  omp_set_num_threads(1);
}

} // namespace plica

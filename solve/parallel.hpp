// Independent pieces of work on all cores.
#pragma once

#include <exception>

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

} // namespace plica

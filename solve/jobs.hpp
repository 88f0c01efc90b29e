// Many pieces of work of their own on several threads, each of which works alone in what it runs.
#pragma once

#include "solve/parallel.hpp"
#include "solve/sparse_factor.hpp"

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

namespace plica {

// Runs f(i) for i in [0, count), in order as they come. `jobs`: 0 = as many as there are cores;
// with one, pieces follow each other on all cores. The first error ends all that has not begun and
// is thrown again.
template <class F> void in_jobs(int count, int jobs, F&& f) {
  if (jobs <= 0) jobs = omp_get_num_procs();
  if (jobs == 1 || count <= 1) {
    set_threads(0);
    for (int i = 0; i < count; ++i) f(i);
    return;
  }
  set_threads(1);
  std::atomic<int> next{0};
  std::exception_ptr error;
  std::mutex mutex;
  std::vector<std::thread> threads;
  for (int job = 0; job < std::min(jobs, count); ++job)
    threads.emplace_back([&] {
      work_alone();
      for (int i = next++; i < count; i = next++) try {
          f(i);
        } catch (...) {
          next = count;
          const std::lock_guard lock(mutex);
          if (!error) error = std::current_exception();
        }
    });
  for (std::thread& thread : threads) thread.join();
  if (error) std::rethrow_exception(error);
}

} // namespace plica

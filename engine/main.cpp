// plica-mpi: the engine for what one machine does not hold.
//
//   mpirun -n 8 plica-mpi CASE --out out
//
// Exit codes as of plica: 0 good, 1 user error, 2 a numerical verdict failed, 3 internal, 4 too
// large for the memory.
#include "app/terminal.hpp"
#include "engine/engine_run.hpp"
#include "engine/petsc.hpp"
#include "io/files/manifest.hpp"
#include "solve/blas_kernels.hpp"
#include "solve/sparse_factor.hpp"

#include <fmt/core.h>
#include <new>

namespace {

using plica::Ranks;

// A node that has another program would send numbers that mean something else.
void require_one_version(const Ranks& ranks) {
  const std::vector<std::string> all = ranks.everyones(
      fmt::format("{} with {}, {}", PLICA_VERSION, PLICA_ENGINE_LIBRARIES,
                  plica::fingerprint_of(std::filesystem::read_symlink("/proc/self/exe"))));
  for (std::size_t r = 1; r < all.size(); ++r)
    if (all[r] != all[0] && ranks.first())
      plica::end_all(
          fmt::format("rank {} runs another program: {}; here it is {}. Install the same "
                      "one on every node",
                      r, all[r], all[0]));
}

[[noreturn]] void end_for_memory() {
  plica::end_all("memory is short: take more nodes, or fewer ranks on each", 4);
}

} // namespace

int main(int argc, char** argv) {
  plica::avoid_faulty_blas_kernels(argv);
  plica::open_standard_streams();
  MPI_Init(&argc, &argv);
  int code = 0;
  {
    const Ranks ranks(MPI_COMM_WORLD);
    std::set_new_handler(end_for_memory);
    plica::EngineOptions options;
    if (const auto done = parse(options, argc, argv, ranks.first())) {
      code = *done;
    } else {
      require_one_version(ranks);
      const plica::PetscSession session;
      plica::set_threads(options.threads);
      code = run_over_ranks(options, ranks);
    }
  }
  MPI_Barrier(MPI_COMM_WORLD);
  MPI_Finalize();
  return code;
}

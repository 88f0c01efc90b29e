// The command line. Exit codes: 0 good, 1 user error (also an output that cannot be written), 2 a
// numerical verdict failed, 3 internal, 4 too large for the memory of this machine.
#include "app/command_line.hpp"
#include "app/interrupt.hpp"
#include "app/terminal.hpp"
#include "mesh/machine_memory.hpp"
#include "solve/base_state.hpp"
#include "solve/blas_kernels.hpp"
#include "solve/sparse_factor.hpp"
#include "words/input_error.hpp"

#include <new>

namespace {

int run_command_line(int argc, char** argv) {
  try {
    return plica::CommandLine().run(argc, argv);
  } catch (const plica::Interrupted& stop) {
    plica::say_failure("plica: stopped before \"" + stop.stage + "\"; no file was written");
    return plica::interrupted_exit();
  } catch (const plica::InputError& error) {
    plica::say_problems(error);
    return 1;
  } catch (const plica::StateError& error) { // no equilibrium, or none that is stable
    plica::say_failure(std::string("plica: ") + error.what());
    return 2;
  } catch (const plica::TooLarge& error) {
    plica::say_failure(std::string("plica: ") + error.what());
    return 4;
  } catch (const std::bad_alloc&) {
    plica::say_failure("plica: not enough memory for this model");
    return 4;
  } catch (const std::exception& error) {
    plica::say_failure(std::string("plica: ") + error.what());
    return 3;
  }
}

} // namespace

int main(int argc, char** argv) {
  plica::avoid_faulty_blas_kernels(argv);
  plica::set_threads(0); // until a command is told how many
  plica::open_standard_streams();
  plica::watch_interrupts();
  return plica::finished(run_command_line(argc, argv));
}

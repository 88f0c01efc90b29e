#include "engine/petsc.hpp"

#include <slepcsys.h>

namespace plica {
namespace {

std::string first_words; // of the error that is on its way up

PetscErrorCode remember(MPI_Comm, int, const char* function, const char*, PetscErrorCode code,
                        PetscErrorType kind, const char* message, void*) {
  if (kind == PETSC_ERROR_INITIAL)
    first_words = std::string(message ? message : "") + " (" + (function ? function : "") + ")";
  return code;
}

} // namespace

void petsc(PetscErrorCode code) {
  if (code == 0) return;
  const std::string words = std::exchange(first_words, "");
  end_all("PETSc: " + (words.empty() ? "error " + std::to_string(code) : words));
}

PetscSession::PetscSession() {
  int argc = 1;
  std::string name = "plica-mpi", no_options = "-skip_petscrc", no_signals = "-no_signal_handler";
  std::vector<char*> words{name.data(), no_options.data(), no_signals.data(), nullptr};
  argc = int(words.size()) - 1;
  char** argv = words.data();
  petsc(SlepcInitialize(&argc, &argv, nullptr, nullptr));
  petsc(PetscPushErrorHandler(remember, nullptr));
}

PetscSession::~PetscSession() {
  PetscPopErrorHandler();
  SlepcFinalize();
}

} // namespace plica

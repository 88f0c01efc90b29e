#include "solve/blas_kernels.hpp"

#include <cstdlib>
#include <string_view>
#include <unistd.h>

extern "C" {
char* openblas_get_config() __attribute__((weak));
char* openblas_get_corename() __attribute__((weak));
}

namespace plica {

void avoid_faulty_blas_kernels(char** argv) {
  if (openblas_get_config == nullptr || openblas_get_corename == nullptr) return;
  constexpr const char* variable = "OPENBLAS_CORETYPE";
  if (std::getenv(variable) != nullptr) return;
  const std::string_view config = openblas_get_config(), core = openblas_get_corename();
  const bool faulty = config.find("0.3.21") != std::string_view::npos &&
                      (core == "SkylakeX" || core == "Cooperlake");
  if (!faulty) return;
  setenv(variable, "Haswell", 1);
  execv("/proc/self/exe", argv); // where that fails, the program goes on as it is
}

} // namespace plica

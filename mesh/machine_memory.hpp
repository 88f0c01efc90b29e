// How much memory a run may take, and the error of a model that needs more.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace plica {

struct MemoryLimit {
  double bytes = 0;
  std::string set_by; // "the memory of this machine"
};

// The least of the machine's memory, the limits of the control groups (cgroups 1 and 2) that this
// process is in, and the limit of its address space (ulimit -v); or what PLICA_MEMORY says, in GB.
// `root`: where proc/ and sys/ are looked for. Throws std::runtime_error when PLICA_MEMORY is no
// number above zero, or when nothing says how much memory there is.
MemoryLimit memory_limit(const std::filesystem::path& root = "/");

// A model that is too large for this machine.
class TooLarge : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Throws TooLarge when `bytes` are more than memory_limit(): "what" needs them, and "instead" says
// what to do about it.
void require_memory(double bytes, const std::string& what, const std::string& instead);

// What a node of a shell mesh takes through the leanest run, by rotational symmetry and without its
// modes: measured on bellows from 1 M to 5 M unknowns, six to a node (docs/speed.md).
inline constexpr double leanest_bytes_per_node = 6 * 400.;

} // namespace plica

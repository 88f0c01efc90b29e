#include "mesh/machine_memory.hpp"

#include "words/short_text.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <sys/resource.h>
#include <sys/sysinfo.h>

namespace plica {
namespace {

namespace fs = std::filesystem;

void take_least(MemoryLimit& limit, double bytes, const std::string& set_by) {
  if (bytes > 0 && bytes < limit.bytes) limit = {bytes, set_by};
}

// MemTotal of /proc/meminfo, or where /proc is not mounted what the kernel says; 0 = not found.
double installed_memory(const fs::path& root) {
  std::ifstream in(root / "proc/meminfo");
  std::string line;
  while (std::getline(in, line)) {
    double kibibytes = 0;
    if (std::sscanf(line.c_str(), "MemTotal: %lf kB", &kibibytes) == 1) return 1024 * kibibytes;
  }
  struct sysinfo machine {};
  if (root == "/" && sysinfo(&machine) == 0)
    return double(machine.totalram) * double(machine.mem_unit);
  return 0;
}

// A file of one number; "max", or none, is no limit.
double number_in(const fs::path& file) {
  std::ifstream in(file);
  double value = 0;
  return in >> value ? value : 0;
}

// The limits of a control group and of those above it, up to the top of its hierarchy.
void take_group(MemoryLimit& limit, const fs::path& hierarchy, const std::string& group,
                const char* file) {
  const std::string set_by = "the limit of its control group";
  for (fs::path path = fs::path(group).relative_path(); !path.empty(); path = path.parent_path())
    take_least(limit, number_in(hierarchy / path / file), set_by);
  take_least(limit, number_in(hierarchy / file), set_by);
}

void take_groups(MemoryLimit& limit, const fs::path& root) {
  std::ifstream in(root / "proc/self/cgroup");
  std::string line;
  while (std::getline(in, line)) { // "0::/group" or "4:memory:/group"
    std::istringstream fields(line);
    std::string number, controllers, group;
    if (!std::getline(fields, number, ':') || !std::getline(fields, controllers, ':') ||
        !std::getline(fields, group))
      continue;
    if (controllers.empty())
      take_group(limit, root / "sys/fs/cgroup", group, "memory.max");
    else if (("," + controllers + ",").find(",memory,") != std::string::npos)
      take_group(limit, root / "sys/fs/cgroup/memory", group, "memory.limit_in_bytes");
  }
}

std::string gigabytes(double bytes) {
  return (bytes < 9.95e9 ? short_text(1e-9 * bytes) : std::to_string(std::lround(1e-9 * bytes))) +
         " GB";
}

} // namespace

MemoryLimit memory_limit(const fs::path& root) {
  if (const char* text = std::getenv("PLICA_MEMORY")) {
    char* end = nullptr;
    const double value = std::strtod(text, &end);
    if (end == text || *end != '\0' || !std::isfinite(value) || !(value > 0))
      throw std::runtime_error(std::string("PLICA_MEMORY is '") + text +
                               "', no number above 0: the memory that a run may take, in GB");
    return {1e9 * value, "PLICA_MEMORY"};
  }
  MemoryLimit limit{std::numeric_limits<double>::infinity(), ""};
  take_least(limit, installed_memory(root), "the memory of this machine");
  take_groups(limit, root);
  rlimit space{};
  if (root == "/" && getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY)
    take_least(limit, double(space.rlim_cur), "the limit of its address space (ulimit -v)");
  if (!std::isfinite(limit.bytes))
    throw std::runtime_error("nothing under " + (root / "proc").string() +
                             " says how much memory there is: set PLICA_MEMORY, in GB");
  return limit;
}

void require_memory(double bytes, const std::string& what, const std::string& instead) {
  const MemoryLimit limit = memory_limit();
  if (bytes <= limit.bytes) return;
  throw TooLarge(what + " needs about " + gigabytes(bytes) + "; " + limit.set_by + " is " +
                 gigabytes(limit.bytes) + ". " + instead +
                 " PLICA_MEMORY sets the limit by hand, in GB.");
}

} // namespace plica

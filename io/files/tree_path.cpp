#include "io/files/tree_path.hpp"

#include <algorithm>
#include <charconv>

namespace plica {

std::vector<TreeStep> steps_of(const std::string& path) {
  std::vector<TreeStep> steps;
  for (std::size_t i = 0; i < path.size();) {
    if (path[i] == '[') {
      const std::size_t end = path.find(']', i);
      if (end == std::string::npos || steps.empty()) return {};
      const std::string inside = path.substr(i + 1, end - i - 1);
      const std::size_t equals = inside.find('=');
      TreeStep step;
      if (equals == std::string::npos) {
        const char* last = inside.data() + inside.size();
        const auto [stop, status] = std::from_chars(inside.data(), last, step.index);
        if (status != std::errc() || stop != last || step.index < 0) return {};
      } else {
        step.key = inside.substr(0, equals);
        step.value = inside.substr(equals + 1);
        if (step.key.empty() || step.value.empty()) return {};
      }
      steps.push_back(step);
      i = end + 1;
      continue;
    }
    if (!steps.empty()) {
      if (path[i] != '.') return {};
      ++i;
    }
    const std::size_t end = std::min(path.find_first_of(".[", i), path.size());
    if (end == i) return {};
    steps.push_back({.key = path.substr(i, end - i), .value = {}});
    i = end;
  }
  return steps;
}

} // namespace plica

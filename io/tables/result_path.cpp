#include "io/tables/result_path.hpp"

#include <charconv>
#include <vector>

namespace plica {
namespace {

struct Step {
  std::string key;   // of a map, or of the entries of a list
  std::string value; // that an entry has there; empty: `key` of a map, or `index`
  int index = -1;
};

// Steps of a path; empty when it is none.
std::vector<Step> steps_of(const std::string& path) {
  std::vector<Step> steps;
  for (std::size_t i = 0; i < path.size();) {
    if (path[i] == '[') {
      const std::size_t end = path.find(']', i);
      if (end == std::string::npos || steps.empty()) return {};
      const std::string inside = path.substr(i + 1, end - i - 1);
      const std::size_t equals = inside.find('=');
      Step step;
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

const Json* next(const Json& place, const Step& step) {
  if (step.index >= 0)
    return place.is_array() && std::size_t(step.index) < place.size()
               ? &place[std::size_t(step.index)]
               : nullptr;
  if (step.value.empty()) {
    const auto found = place.is_object() ? place.find(step.key) : place.end();
    return found == place.end() ? nullptr : &*found;
  }
  if (!place.is_array()) return nullptr;
  for (const Json& entry : place) {
    const auto found = entry.is_object() ? entry.find(step.key) : entry.end();
    if (found == entry.end()) continue;
    if (found->is_string() ? *found == step.value : found->dump() == step.value) return &entry;
  }
  return nullptr;
}

} // namespace

std::string bad_result_path(const std::string& path) {
  return steps_of(path).empty() ? "'" + path + "' is no path of results.json" : "";
}

std::optional<double> number_in(const Json& results, const std::string& path) {
  const Json* place = &results;
  for (const Step& step : steps_of(path))
    if (place = next(*place, step); !place) return std::nullopt;
  if (place->is_boolean()) return place->get<bool>() ? 1 : 0;
  if (!place->is_number()) return std::nullopt;
  return place->get<double>();
}

} // namespace plica

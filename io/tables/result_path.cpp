#include "io/tables/result_path.hpp"

#include "io/files/tree_path.hpp"

namespace plica {
namespace {

const Json* next(const Json& place, const TreeStep& step) {
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
  for (const TreeStep& step : steps_of(path))
    if (place = next(*place, step); !place) return std::nullopt;
  if (place->is_boolean()) return place->get<bool>() ? 1 : 0;
  if (!place->is_number()) return std::nullopt;
  return place->get<double>();
}

} // namespace plica

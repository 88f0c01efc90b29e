#include "io/input/yaml_path.hpp"

#include "io/files/tree_path.hpp"
#include "words/did_you_mean.hpp"

#include <algorithm>

namespace plica {

namespace {

std::vector<std::string> keys_of(const YamlNode& node) {
  std::vector<std::string> keys;
  for (const YamlEntry& entry : node.entries) keys.push_back(entry.key);
  return keys;
}

} // namespace

PathProblem put(YamlNode& root, const std::string& path, const std::string& value, int line) {
  const std::vector<TreeStep> steps = steps_of(path);
  const auto by_value = [](const TreeStep& step) { return !step.value.empty(); };
  if (steps.empty() || std::any_of(steps.begin(), steps.end(), by_value))
    return {"'" + shown(path) + "' is not a path", "write it like parts.bellows.profile[1].height"};
  YamlNode *node = &root, *map = nullptr; // the map that holds the last key
  std::string here;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool last = i + 1 == steps.size();
    const std::string place = here.empty() ? "the file" : here;
    if (steps[i].index >= 0) {
      const int n = static_cast<int>(node->items.size());
      here += "[" + std::to_string(steps[i].index) + "]";
      if (node->kind != YamlNode::Kind::list || steps[i].index >= n)
        return {"there is no '" + shown(path) + "' in this file",
                place + (node->kind != YamlNode::Kind::list
                             ? " is not a list"
                             : " has " + std::to_string(n) + (n == 1 ? " item" : " items") +
                                   ", counted from 0")};
      node = &node->items[static_cast<std::size_t>(steps[i].index)];
      continue;
    }
    YamlNode* next = node->find(steps[i].key);
    if (!next && last && node->kind == YamlNode::Kind::map) {
      node->entries.push_back({steps[i].key, line, {}});
      next = &node->entries.back().value;
    }
    if (!next)
      return {"there is no '" + shown(path) + "' in this file",
              node->kind == YamlNode::Kind::map
                  ? "in " + place + ": " + suggestion(steps[i].key, keys_of(*node))
                  : place + " is not a map"};
    here += (here.empty() ? "" : ".") + steps[i].key;
    map = node;
    node = next;
  }
  std::vector<InputProblem> problems;
  YamlNode tree = parse_yaml(value, "", problems);
  if (!problems.empty()) return {"'" + shown(value) + "' is not YAML: " + problems[0].wrong, ""};
  if (tree.kind == YamlNode::Kind::null && map && steps.back().index < 0) {
    std::erase_if(map->entries, [&](const YamlEntry& e) { return e.key == steps.back().key; });
    return {};
  }
  *node = std::move(tree);
  set_lines(*node, line);
  return {};
}

} // namespace plica

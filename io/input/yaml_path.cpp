#include "io/input/yaml_path.hpp"

#include "words/did_you_mean.hpp"

#include <charconv>
#include <vector>

namespace plica {

namespace {

struct Step {
  std::string key; // empty: an index
  int index = 0;
};

// Steps of a path; empty when it is not one.
std::vector<Step> steps_of(const std::string& path) {
  std::vector<Step> steps;
  for (std::size_t i = 0; i < path.size();) {
    if (path[i] == '[') {
      int index = -1;
      const char* end = path.data() + path.size();
      const auto [stop, status] = std::from_chars(path.data() + i + 1, end, index);
      if (status != std::errc() || index < 0 || stop == end || *stop != ']' || steps.empty())
        return {};
      steps.push_back({"", index});
      i = static_cast<std::size_t>(stop - path.data()) + 1;
      continue;
    }
    if (!steps.empty()) {
      if (path[i] != '.') return {};
      ++i;
    }
    const std::size_t end = std::min(path.find_first_of(".[", i), path.size());
    if (end == i) return {};
    steps.push_back({path.substr(i, end - i)});
    i = end;
  }
  return steps;
}

std::vector<std::string> keys_of(const YamlNode& node) {
  std::vector<std::string> keys;
  for (const YamlEntry& entry : node.entries) keys.push_back(entry.key);
  return keys;
}

} // namespace

PathProblem put(YamlNode& root, const std::string& path, const std::string& value, int line) {
  const std::vector<Step> steps = steps_of(path);
  if (steps.empty())
    return {"'" + shown(path) + "' is not a path", "write it like parts.bellows.profile[1].height"};
  YamlNode *node = &root, *map = nullptr; // the map that holds the last key
  std::string here;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool last = i + 1 == steps.size();
    const std::string place = here.empty() ? "the file" : here;
    if (steps[i].key.empty()) {
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
  if (tree.kind == YamlNode::Kind::null && map && !steps.back().key.empty()) {
    std::erase_if(map->entries, [&](const YamlEntry& e) { return e.key == steps.back().key; });
    return {};
  }
  *node = std::move(tree);
  set_lines(*node, line);
  return {};
}

} // namespace plica

// Places of a YAML tree by path: "parts.bellows.profile[1].height".
#pragma once

#include "io/input/yaml_tree.hpp"

#include <string>

namespace plica {

struct PathProblem {
  std::string wrong, allowed; // empty = good
};

// Puts `value` (YAML text) where `path` points; every line of it becomes `line`. The last key of
// the path may be new, all before it must exist; `null` takes a key out.
PathProblem put(YamlNode& root, const std::string& path, const std::string& value, int line);

} // namespace plica

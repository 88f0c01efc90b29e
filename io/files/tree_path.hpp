// Places in a tree of maps and lists: "parts.bellows.profile[1].height",
// "responses[base=y].peaks[0].amplitude".
#pragma once

#include <string>
#include <vector>

namespace plica {

struct TreeStep {
  std::string key;   // of a map, or of the entries of a list
  std::string value; // that an entry has there; empty: `key` of a map, or `index`
  int index = -1;    // into a list, from 0; -1: by `key`
};

// Empty when `path` is none.
std::vector<TreeStep> steps_of(const std::string& path);

} // namespace plica

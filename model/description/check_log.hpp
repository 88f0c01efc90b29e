// Collects what the rules between keys find wrong, and knows what could not be read at all: what
// depends on that is not judged.
#pragma once

#include "model/description/case.hpp"
#include "words/input_error.hpp"

#include <set>
#include <string>
#include <vector>

namespace plica {

// True if `key` is `ancestor` or lies below it.
bool is_below(const std::string& key, const std::string& ancestor);

// "list[i]"
std::string item(const std::string& list, std::size_t i);

// Axes of a sensor: each of 1, 2, 3 once, with a sign.
bool are_three_axes(std::vector<int> axes);
inline constexpr const char* three_axes =
    "allowed: x, y and z once each, with a sign, e.g. [x, -z, y]";

class CheckLog {
public:
  // `bad`: keys already found wrong.
  CheckLog(const Case& data, std::vector<std::string> bad);

  std::vector<InputProblem> problems; // file and line stay empty

  void add(const std::string& key, std::string wrong, std::string allowed);

  // Nothing at, above or below this key was found wrong while reading.
  bool fine(const std::string& key) const;

  // `name` at `key` differs from those already in `names`, and joins them.
  void once(std::set<std::string>& names, const std::string& name, const std::string& key,
            const std::string& kind);

  // `name` at `key` must be one of `names`; `kind` says what it names.
  void reference(const std::string& key, const std::string& kind, const std::string& name,
                 const std::vector<std::string>& names);

  // The same for node sets of the case.
  void set_reference(const std::string& key, const std::string& name);

private:
  // False when the part that has or would have this node set could not be read.
  bool sets_known(const std::string& set) const;

  std::vector<std::string> bad_;
  std::vector<std::string> sets_;
};

} // namespace plica

#include "model/description/check_log.hpp"

#include "model/description/node_sets.hpp"
#include "model/description/place_keys.hpp"
#include "words/did_you_mean.hpp"

#include <algorithm>

namespace plica {

bool is_below(const std::string& key, const std::string& ancestor) {
  if (!key.starts_with(ancestor)) return false;
  return key.size() == ancestor.size() || ancestor.empty() || key[ancestor.size()] == '.' ||
         key[ancestor.size()] == '[';
}

std::string item(const std::string& list, std::size_t i) {
  return list + "[" + std::to_string(i) + "]";
}

CheckLog::CheckLog(const Case& data, std::vector<std::string> bad)
    : bad_(std::move(bad)), sets_(set_names(data)) {
  std::erase_if(sets_, [&](const std::string& set) { return !sets_known(set); });
}

void CheckLog::add(const std::string& key, std::string wrong, std::string allowed) {
  problems.push_back({"", 0, key, std::move(wrong), std::move(allowed)});
}

bool CheckLog::fine(const std::string& key) const {
  return std::none_of(bad_.begin(), bad_.end(),
                      [&](const std::string& b) { return is_below(b, key) || is_below(key, b); });
}

bool CheckLog::sets_known(const std::string& set) const {
  const std::string part = part_key(part_of_set(set));
  return fine(part + ".type") && fine(part + ".profile") && fine(part + ".points") &&
         fine(part + ".file");
}

bool are_three_axes(std::vector<int> axes) {
  for (int& axis : axes) axis = std::abs(axis);
  std::sort(axes.begin(), axes.end());
  return axes == std::vector<int>{1, 2, 3};
}

void CheckLog::once(std::set<std::string>& names, const std::string& name, const std::string& key,
                    const std::string& kind) {
  if (fine(key) && !names.insert(name).second)
    add(key, "the name '" + shown(name) + "' is used by another " + kind, "names must differ");
}

void CheckLog::reference(const std::string& key, const std::string& kind, const std::string& name,
                         const std::vector<std::string>& names) {
  if (!fine(key) || std::find(names.begin(), names.end(), name) != names.end()) return;
  if (!sets_known(name)) return;
  add(key, "there is no " + kind + " '" + shown(name) + "'",
      names.empty() ? "this case has none" : suggestion(name, names));
}

void CheckLog::set_reference(const std::string& key, const std::string& name) {
  reference(key, "node set", name, sets_);
}

} // namespace plica

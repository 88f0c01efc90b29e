#include "lab/measured/entries.hpp"

#include <algorithm>

namespace plica {

std::string entry_name(const char* list, std::size_t i) {
  return std::string(list) + "[" + std::to_string(i) + "]";
}

std::string weighing_name(const Measured& measured, std::size_t i) {
  return measured.weighings.size() == 1 ? "mass" : entry_name("mass", i);
}

bool is_held_out(const Measured& measured, const std::string& entry) {
  return std::any_of(
      measured.hold_out.begin(), measured.hold_out.end(), [&](const std::string& held) {
        return entry == held || entry.starts_with(held + ".") || entry.starts_with(held + "[");
      });
}

std::vector<std::string> renamed_paths(const std::vector<std::string>& paths,
                                       const std::map<std::string, std::string>& now) {
  std::vector<std::string> renamed;
  for (const std::string& path : paths) {
    const std::size_t entry_end = std::min(path.find(']'), path.size() - 1) + 1;
    const auto found = now.find(path.substr(0, entry_end));
    if (found != now.end()) renamed.push_back(found->second + path.substr(entry_end));
  }
  return renamed;
}

} // namespace plica

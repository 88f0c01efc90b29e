#include "app/case_in_folder.hpp"

#include "words/input_error.hpp"

#include <algorithm>
#include <fstream>
#include <vector>

namespace plica {
namespace {

namespace fs = std::filesystem;

bool is_case(const fs::path& path) {
  if (path.extension() != ".yaml" && path.extension() != ".yml") return false;
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return false;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("case:") || line.starts_with("benchmark:")) return true;
  return false;
}

} // namespace

std::string case_file_of(const std::string& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return path;
  const fs::path own =
      fs::path(path) / (fs::canonical(path, ignored).filename().string() + ".yaml");
  if (fs::exists(own, ignored)) return own.string();
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(path, ignored))
    if (is_case(entry.path())) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  if (names.size() == 1) return (fs::path(path) / names[0]).string();
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  throw InputError({{.file = path,
                     .line = 0,
                     .key = "",
                     .wrong = names.empty() ? "has no case in it" : "has several cases in it",
                     .allowed = names.empty() ? "a folder with one case file (*.yaml)"
                                              : "one of them: " + all}});
}

} // namespace plica

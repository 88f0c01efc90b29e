#include "io/files/manifest.hpp"

#include "io/files/files.hpp"
#include "io/files/fnv.hpp"
#include "io/files/json_text.hpp"
#include "words/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plica {
namespace {

namespace fs = std::filesystem;

constexpr const char* about =
    "Files that plica wrote here. It replaces or removes only these, and only while they are as "
    "it wrote them.";

// A name, or a name in one folder below.
bool is_name_below(const std::string& name) {
  const fs::path path(name);
  const auto steps = std::distance(path.begin(), path.end());
  return steps >= 1 && steps <= 2 && path.is_relative() &&
         std::none_of(path.begin(), path.end(), [](const fs::path& step) {
           return step.empty() || step == "." || step == "..";
         });
}

} // namespace

std::string fingerprint(const std::string& content) {
  Fnv1a print;
  print.add(content.data(), content.size());
  return fmt::format("{}-{:016x}", content.size(), print.hash());
}

std::string fingerprint_of(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(fs::symlink_status(file, ignored))) return "";
  try {
    return fingerprint(read_whole(file));
  } catch (const std::runtime_error&) {
    return "";
  }
}

Manifest read_manifest(const fs::path& folder) {
  const fs::path file = folder / manifest_name;
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(file, ignored))) return {};
  Manifest manifest;
  try {
    const Json json = Json::parse(read_whole(file));
    for (const auto& [name, entry] : json.at("files").items())
      if (is_name_below(name))
        manifest[name] = {entry.at("command"), entry.at("prints").get<std::vector<std::string>>(),
                          entry.value("plica_version", "")};
  } catch (const std::exception&) { // cannot be read, is no JSON, has other keys
    throw InputError({{.file = file.string(),
                       .line = 0,
                       .key = "",
                       .wrong = "is no list of files that plica wrote",
                       .allowed = "remove it, or another folder with --out"}});
  }
  return manifest;
}

std::string manifest_text(const Manifest& manifest) {
  Json files = Json::object();
  for (const auto& [name, file] : manifest)
    files[name] = {
        {"command", file.command}, {"plica_version", file.version}, {"prints", file.prints}};
  return json_text({{"about", about}, {"files", files}});
}

} // namespace plica

#include "io/files/output_folder.hpp"

#include "io/files/files.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace plica {
namespace {

namespace fs = std::filesystem;

constexpr const char* aside_prefix = ".plica-";
constexpr std::size_t random_letters = 6;

const fs::path& made(const fs::path& folder) {
  make_folder(folder);
  return folder;
}

// What a killed run left: its name is what the lock says, and nothing but such a name is removed.
void remove_left(const fs::path& folder, const std::string& name) {
  const std::string prefix = aside_prefix;
  if (!name.starts_with(prefix) || name.size() != prefix.size() + random_letters ||
      !std::all_of(name.begin() + std::ptrdiff_t(prefix.size()), name.end(),
                   [](unsigned char c) { return std::isalnum(c) != 0; }))
    return;
  std::error_code ignored;
  if (fs::is_directory(fs::symlink_status(folder / name, ignored)))
    fs::remove_all(folder / name, ignored);
}

fs::path folder_aside(const fs::path& folder) {
  std::string name = (folder / aside_prefix).string() + std::string(random_letters, 'X');
  if (!mkdtemp(name.data()))
    throw InputError({{.file = folder.string(),
                       .line = 0,
                       .key = "",
                       .wrong = std::string("cannot write here: ") + std::strerror(errno),
                       .allowed = "a folder that can be written, with --out"}});
  return name;
}

InputProblem problem(const fs::path& file, const std::string& wrong, const std::string& allowed) {
  return {.file = file.string(), .line = 0, .key = "", .wrong = wrong, .allowed = allowed};
}

} // namespace

OutputFolder::OutputFolder(fs::path folder, OutputWork work)
    : folder_(std::move(folder)), work_(std::move(work)), lock_(made(folder_)),
      manifest_(read_manifest(folder_)) {
  remove_left(folder_, lock_.left());
  std::erase_if(work_.names, [&](const std::string& name) { return !wants(name); });
  std::vector<InputProblem> problems;
  for (const std::string& name : work_.names) check(name, problems);
  if (problems.empty()) return;
  constexpr std::size_t most_named = 4;
  if (const std::size_t all = problems.size(); all > most_named) {
    problems.resize(most_named);
    problems.back() = problem(
        folder_, std::to_string(all - most_named + 1) + " more names are taken in the same way",
        "another folder with --out");
  }
  throw InputError(std::move(problems));
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!aside_.empty()) fs::remove_all(aside_, ignored);
}

bool OutputFolder::is_input(const fs::path& file) const {
  std::error_code ignored; // of what is not there
  return std::any_of(work_.inputs.begin(), work_.inputs.end(),
                     [&](const fs::path& input) { return fs::equivalent(file, input, ignored); });
}

// Links are not followed: a link of the user's is the user's.
void OutputFolder::check(const std::string& name, std::vector<InputProblem>& problems) const {
  const fs::path file = folder_ / name;
  std::error_code ignored;
  if (const fs::path below = fs::path(name).parent_path(); !below.empty()) {
    const fs::file_status status = fs::symlink_status(folder_ / below, ignored);
    if (fs::exists(status) && !fs::is_directory(status)) {
      problems.push_back(problem(folder_ / below, "is no folder, and results would go into it",
                                 "move it away, or another folder with --out"));
      return;
    }
  }
  if (!fs::exists(fs::symlink_status(file, ignored))) return;
  const auto known = manifest_.find(name);
  if (is_input(file))
    problems.push_back(problem(file, "is an input of this command, which would write over it",
                               "another folder with --out"));
  else if (known == manifest_.end())
    problems.push_back(problem(file, "is no file that plica wrote, and its name is needed",
                               "move it away, or another folder with --out"));
  else if (const auto& prints = known->second.prints;
           std::find(prints.begin(), prints.end(), fingerprint_of(file)) == prints.end())
    problems.push_back(problem(file, "was changed since plica wrote it, and would be replaced",
                               "move it away, or another folder with --out"));
}

fs::path OutputFolder::place(const std::string& name) {
  std::vector<InputProblem> problems;
  if (std::find(work_.names.begin(), work_.names.end(), name) == work_.names.end())
    check(name, problems);
  if (!problems.empty()) throw InputError(std::move(problems));
  if (aside_.empty()) {
    aside_ = folder_aside(folder_);
    lock_.leave(aside_.filename().string());
  }
  const fs::path file = aside_ / name;
  make_folder(file.parent_path());
  added_.push_back(name);
  return file;
}

bool OutputFolder::wants(const std::string& name) const {
  return !work_.json_only || name.ends_with(".json") || name.ends_with(".yaml");
}

fs::path OutputFolder::shown(const std::string& page, const std::string& json) const {
  return folder_ / (wants(page) ? page : json);
}

void OutputFolder::add(const std::string& name, const std::string& content) {
  if (!wants(name)) return;
  write_new(place(name), content, folder_ / name);
}

void OutputFolder::add_by(const std::string& name,
                          const std::function<void(const fs::path&)>& write) {
  if (!wants(name)) return;
  const fs::path file = place(name);
  try {
    write(file);
  } catch (const std::exception& error) {
    throw InputError({problem(folder_ / name, std::string("cannot be written: ") + error.what(),
                              "a place with room for it, with --out")});
  }
}

void OutputFolder::write_manifest() {
  const fs::path file = aside_ / manifest_name;
  write_new(file, manifest_text(manifest_), folder_ / manifest_name);
  fs::rename(file, folder_ / manifest_name);
}

// The work is done: it is not thrown away.
void OutputFolder::keep_aside(const std::string& why) {
  const fs::path kept =
      folder_ / ("kept_" + aside_.filename().string().substr(std::strlen(aside_prefix)));
  std::error_code error;
  fs::rename(aside_, kept, error);
  const fs::path where = error ? aside_ : kept;
  aside_.clear();
  throw InputError(
      {problem(folder_, "cannot take the results: " + why, "they are whole in " + where.string())});
}

// Until the last file is in its place the list has the old and the new fingerprints: whenever this
// ends, all that stands here is known.
void OutputFolder::commit() {
  if (added_.empty()) return;
  std::vector<InputProblem> problems;
  for (const std::string& name : added_) check(name, problems);
  if (!problems.empty()) keep_aside(to_string(problems.front()));
  std::map<std::string, std::string> prints;
  try {
    for (const std::string& name : added_) {
      prints[name] = fingerprint_of(aside_ / name);
      if (prints[name].empty()) throw std::runtime_error(name + " was not written");
      WrittenFile& file = manifest_[name];
      file.command = work_.command;
      file.version = PLICA_VERSION;
      file.prints.push_back(prints[name]);
    }
    write_manifest();
    for (const std::string& name : added_) {
      make_folder((folder_ / name).parent_path());
      fs::rename(aside_ / name, folder_ / name);
      manifest_[name].prints = {prints[name]};
    }
    write_manifest();
  } catch (const std::exception& error) {
    keep_aside(error.what());
  }
  written_.insert(written_.end(), added_.begin(), added_.end());
  added_.clear();
}

std::vector<std::string> OutputFolder::remove_stale() {
  std::vector<std::string> changed;
  std::error_code ignored;
  const Manifest before = manifest_;
  for (const auto& [name, file] : before) {
    const bool own = file.command == work_.command &&
                     std::find(written_.begin(), written_.end(), name) == written_.end();
    if (!own) continue;
    const fs::path path = folder_ / name;
    const fs::path below = fs::path(name).parent_path();
    const bool there = fs::exists(fs::symlink_status(path, ignored)) &&
                       !fs::is_symlink(fs::symlink_status(folder_ / below, ignored));
    const std::string print = there ? fingerprint_of(path) : "";
    const bool as_written =
        std::find(file.prints.begin(), file.prints.end(), print) != file.prints.end();
    if (there && (!as_written || is_input(path))) {
      changed.push_back(name);
    } else if (there) {
      fs::remove(path, ignored);
      if (!below.empty() && fs::is_empty(folder_ / below, ignored))
        fs::remove(folder_ / below, ignored);
    }
    manifest_.erase(name);
  }
  if (manifest_.size() != before.size() && !aside_.empty()) write_manifest();
  return changed;
}

} // namespace plica

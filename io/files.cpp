#include "io/files.hpp"

#include "model/input_error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

namespace plica {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& what, const fs::path& path, const std::string& why) {
  throw InputError({{.file = path.string(),
                     .line = 0,
                     .key = "",
                     .wrong = "cannot " + what + ": " + why,
                     .allowed = "a place that can be written"}});
}

void write_to(const fs::path& path, const fs::path& target, const std::string& content) {
  errno = 0;
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  if (stream) stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream) fail("write", target, errno != 0 ? std::strerror(errno) : "the disk may be full");
}

void move_to(const fs::path& temporary, const fs::path& target) {
  std::error_code error;
  fs::rename(temporary, target, error);
  if (error) fail("write", target, error.message());
}

fs::path temporary_of(const fs::path& target) {
  return target.parent_path() / ("." + target.filename().string() + ".part");
}

} // namespace

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail("make the folder for the results", folder, error.message());
  if (!fs::is_directory(folder, error))
    fail("write the results here", folder, "it is a file, not a folder");
}

void write_whole(const fs::path& target, const std::string& content) {
  FileSet one(target.has_parent_path() ? target.parent_path() : fs::path("."));
  one.add(target.filename().string(), content);
  one.commit();
}

std::string read_whole(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + path.string());
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

FileSet::FileSet(fs::path folder) : folder_(std::move(folder)) {
  make_folder(folder_);
}

FileSet::~FileSet() {
  std::error_code ignored;
  for (const File& file : files_) fs::remove(file.temporary, ignored);
}

fs::path FileSet::place(const std::string& name) {
  const fs::path target = folder_ / name;
  std::error_code ignored;
  if (fs::is_directory(target, ignored)) fail("write", target, "a folder has this name");
  files_.push_back({name, temporary_of(target)});
  return files_.back().temporary;
}

void FileSet::add(const std::string& name, const std::string& content) {
  write_to(place(name), folder_ / name, content);
}

void FileSet::commit() {
  for (const File& file : files_) move_to(file.temporary, folder_ / file.name);
}

bool FileSet::holds(const std::string& name) const {
  return std::any_of(files_.begin(), files_.end(), [&](const File& f) { return f.name == name; });
}

} // namespace plica

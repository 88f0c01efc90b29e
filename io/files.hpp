// Files that are written whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plica {

// Makes the folder; InputError with path and reason when that cannot be, so that a run finds out
// before it computes.
void make_folder(const std::filesystem::path& folder);

// Writes into a temporary file beside the target and renames it. InputError with path and reason.
void write_whole(const std::filesystem::path& target, const std::string& content);

// Text of a file; std::runtime_error when it cannot be read.
std::string read_whole(const std::filesystem::path& path);

// Files of one run: all are written under temporary names, and `commit` renames them in the order
// in which they were added. Without it nothing of an older run is touched.
class FileSet {
public:
  explicit FileSet(std::filesystem::path folder); // makes it
  ~FileSet();                                     // removes what was not committed
  FileSet(const FileSet&) = delete;
  FileSet& operator=(const FileSet&) = delete;

  void add(const std::string& name, const std::string& content);
  std::filesystem::path place(const std::string& name); // for a writer of its own
  void commit();
  bool holds(const std::string& name) const;

private:
  struct File {
    std::string name;
    std::filesystem::path temporary;
  };
  std::filesystem::path folder_;
  std::vector<File> files_;
};

} // namespace plica

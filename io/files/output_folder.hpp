// The folder of results of one command, from before its work until its files are there.
//
//   OutputFolder out("out", {.command = "run", .inputs = {case_file}, .names = {"results.json"}});
//   ... the work ...
//   out.add("results.json", text);
//   out.commit();        // all files appear, in the order in which they were added
//   out.remove_stale();  // what an earlier run of the command left and this one does not write
//
// No file is lost: what plica_files.json of the folder (io/files/manifest.hpp) does not list, or
// what was changed since, is neither replaced nor removed, and inputs of the command never are. All
// is written into a folder aside first; without commit() nothing of an older run is touched. A
// second command that writes here at the same time is refused.
#pragma once

#include "io/files/folder_lock.hpp"
#include "io/files/manifest.hpp"
#include "words/input_error.hpp"

#include <functional>

namespace plica {

struct OutputWork {
  std::string command;
  std::vector<std::filesystem::path> inputs; // all it reads
  std::vector<std::string> names;            // of files it will write, as far as known beforehand
  bool json_only = false;                    // of all files those of JSON and cases are written
};

class OutputFolder {
public:
  // Makes the folder. InputError before the work: the folder cannot be written or is in use, a name
  // is taken by a file that is not the command's to replace.
  OutputFolder(std::filesystem::path folder, OutputWork work);
  ~OutputFolder(); // removes what was not committed
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& path() const { return folder_; }
  const std::string& command() const { return work_.command; }

  // False for a file that was not asked for: adding it does nothing.
  bool wants(const std::string& name) const;
  // Of a page and the JSON beside it the path of the one that is written.
  std::filesystem::path shown(const std::string& page, const std::string& json) const;

  // A name may stand in one folder below: "2/modes.csv".
  void add(const std::string& name, const std::string& content);
  // With a writer of its own; what it throws becomes an InputError.
  void add_by(const std::string& name,
              const std::function<void(const std::filesystem::path&)>& write);

  // A file that took one of the names meanwhile is an InputError that says where the results are.
  void commit();

  // Names of what was changed since it was written, and therefore stays.
  std::vector<std::string> remove_stale();

private:
  std::filesystem::path place(const std::string& name);
  void check(const std::string& name, std::vector<InputProblem>& problems) const;
  bool is_input(const std::filesystem::path& file) const;
  void write_manifest();
  [[noreturn]] void keep_aside(const std::string& why);

  std::filesystem::path folder_;
  OutputWork work_;
  FolderLock lock_;
  Manifest manifest_;
  std::filesystem::path aside_;
  std::vector<std::string> added_, written_;
};

} // namespace plica

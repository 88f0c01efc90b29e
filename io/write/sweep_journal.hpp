// What became of the variants of a sweep, kept as they finish: a file of JSON lines in the folder
// of results, appended to by one process alone, one file a shard. A process that is killed loses
// what it was at; a half-written last line is left out.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace plica {

struct SweepRecord {
  std::vector<std::pair<std::string, double>> values; // result, value
  std::string failure;                                // why there are none
  double seconds = 0;                                 // that it took
};
using SweepRecords = std::map<std::string, SweepRecord>; // by what was run

// "runs.jsonl", of one shard of several "runs_2_of_8.jsonl".
std::string journal_name(int shard, int shards);

// Of all shards in a folder. `damaged`: names of files with lines that cannot be read.
SweepRecords read_journals(const std::filesystem::path& folder, std::vector<std::string>& damaged);

class SweepJournal {
public:
  // Makes the folder. InputError when it cannot be written, when another process writes this shard,
  // or when a file that is none has its name.
  SweepJournal(const std::filesystem::path& folder, int shard, int shards);
  ~SweepJournal();
  SweepJournal(const SweepJournal&) = delete;
  SweepJournal& operator=(const SweepJournal&) = delete;

  // Stays when the process ends right after. InputError when the disk is full.
  void add(const std::string& run, const SweepRecord& record);

private:
  std::filesystem::path file_;
  int handle_ = -1;
};

} // namespace plica

#include "io/write/sweep_journal.hpp"

#include "io/files/files.hpp"
#include "io/files/folder_lock.hpp"
#include "io/files/json_text.hpp"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

namespace plica {
namespace {

namespace fs = std::filesystem;

constexpr const char* first_line = "{\"plica\": \"runs of a sweep\"}\n";

[[noreturn]] void refuse(const fs::path& file, const std::string& wrong,
                         const std::string& allowed) {
  throw InputError(
      {{.file = file.string(), .line = 0, .key = "", .wrong = wrong, .allowed = allowed}});
}

std::string line_of(const std::string& run, const SweepRecord& record) {
  Json json{{"run", run}, {"seconds", std::round(1e3 * record.seconds) / 1e3}};
  if (record.failure.empty()) {
    json["values"] = Json::object();
    for (const auto& [result, value] : record.values) json["values"][result] = value;
  } else {
    json["failure"] = record.failure;
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

// False for a line that is none.
bool read_line(const std::string& line, SweepRecords& records) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object() || !json.contains("run") || !json["run"].is_string()) return false;
  SweepRecord record;
  if (json.contains("seconds") && json["seconds"].is_number()) record.seconds = json["seconds"];
  if (json.contains("failure") && json["failure"].is_string())
    record.failure = json["failure"];
  else if (json.contains("values") && json["values"].is_object())
    for (const auto& [result, value] : json["values"].items()) {
      if (!value.is_number()) return false;
      record.values.emplace_back(result, value.get<double>());
    }
  else
    return false;
  records[json["run"]] = std::move(record);
  return true;
}

bool is_journal(const fs::path& file) {
  const std::string name = file.filename().string();
  return name == "runs.jsonl" || (name.starts_with("runs_") && name.ends_with(".jsonl"));
}

} // namespace

std::string journal_name(int shard, int shards) {
  return shards == 1 ? "runs.jsonl"
                     : "runs_" + std::to_string(shard) + "_of_" + std::to_string(shards) + ".jsonl";
}

SweepRecords read_journals(const fs::path& folder, std::vector<std::string>& damaged) {
  SweepRecords records;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (!is_journal(entry.path()) || !entry.is_regular_file()) continue;
    const std::string text = read_whole(entry.path());
    std::istringstream lines(text);
    bool good = true;
    std::string line;
    for (bool first = true; std::getline(lines, line); first = false)
      if (!first && !line.empty() && !lines.eof()) good = read_line(line, records) && good;
    if (!good) damaged.push_back(entry.path().filename().string());
  }
  return records;
}

SweepJournal::SweepJournal(const fs::path& folder, int shard, int shards)
    : file_(folder / journal_name(shard, shards)) {
  make_folder(folder);
  handle_ =
      open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
  struct stat status {};
  if (handle_ < 0 || fstat(handle_, &status) != 0 || !S_ISREG(status.st_mode)) {
    const std::string why = handle_ < 0 ? std::strerror(errno) : "it is no file";
    if (handle_ >= 0) close(handle_);
    refuse(file_, "cannot be written: " + why, "a folder that can be written, with --out");
  }
  struct flock lock {}; // of this handle: reading the file by another leaves it
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  if (fcntl(handle_, F_OFD_SETLK, &lock) != 0 && (errno == EACCES || errno == EAGAIN)) {
    close(handle_);
    throw FolderInUse({{.file = file_.string(),
                        .line = 0,
                        .key = "",
                        .wrong = "another plica is running this sweep",
                        .allowed = "wait until it has ended, or --shard"}});
  }
  std::string begin(std::strlen(first_line), '\0');
  const ssize_t n = pread(handle_, begin.data(), begin.size(), 0);
  if (status.st_size > 0 && (n != ssize_t(begin.size()) || begin != first_line)) {
    close(handle_);
    refuse(file_, "is no file of a sweep", "another folder with --out");
  }
  char last = '\n';
  if (status.st_size > 0) pread(handle_, &last, 1, status.st_size - 1);
  const std::string open_with = status.st_size == 0 ? first_line : last == '\n' ? "" : "\n";
  if (!open_with.empty() &&
      write(handle_, open_with.data(), open_with.size()) != ssize_t(open_with.size())) {
    close(handle_);
    refuse(file_, "cannot be written", "room on the disk");
  }
}

SweepJournal::~SweepJournal() {
  if (handle_ >= 0) close(handle_);
}

void SweepJournal::add(const std::string& run, const SweepRecord& record) {
  const std::string line = line_of(run, record);
  std::size_t done = 0;
  while (done < line.size()) {
    const ssize_t n = write(handle_, line.data() + done, line.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0)
      refuse(file_, std::string("cannot be written: ") + std::strerror(n < 0 ? errno : EIO),
             "room on the disk; what was run so far is kept");
    done += std::size_t(n);
  }
}

} // namespace plica

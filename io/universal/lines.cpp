#include "io/universal/lines.hpp"

#include "io/universal/numbers.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace plica::universal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t chunk = std::size_t(1) << 18;
constexpr std::uint64_t longest_line = std::uint64_t(1) << 26;

[[noreturn]] void unreadable(const std::string& file, const std::string& wrong,
                             const std::string& allowed) {
  throw InputError({{.file = file, .line = 0, .key = "", .wrong = wrong, .allowed = allowed}});
}

// A pipe or a device would block or never end.
std::uint64_t size_of_regular(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status))
    unreadable(path.string(), "the file does not exist", "the path of a universal file");
  if (fs::is_directory(status))
    unreadable(path.string(), "is a folder", "the path of a universal file");
  if (!fs::is_regular_file(status))
    unreadable(path.string(), "is not a regular file", "the path of a universal file");
  const std::uint64_t size = fs::file_size(path, error);
  if (error) unreadable(path.string(), "cannot be read: " + error.message(), "a readable file");
  return size;
}

} // namespace

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

bool is_delimiter(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first != std::string_view::npos && line.substr(first, 2) == "-1" &&
         is_blank(line.substr(first + 2));
}

bool is_exact_delimiter(std::string_view line) {
  return is_delimiter(line) && line.starts_with("    -1");
}

Lines::Lines(const fs::path& path) : size_(size_of_regular(path)), name_(path.string()) {
  if (size_ == 0) unreadable(name_, "the file is empty", "data sets between lines of -1");
  errno = 0;
  stream_ = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*stream_)
    unreadable(name_, std::string("cannot be read: ") + std::strerror(errno), "a readable file");
}

Lines::Lines(std::unique_ptr<std::istream> stream, std::uint64_t size, std::string name)
    : stream_(std::move(stream)), size_(size), name_(std::move(name)) {
  if (size_ == 0) unreadable(name_, "the file is empty", "data sets between lines of -1");
}

std::string_view Lines::raw() const {
  if (line_.begin < base_) return {};
  return {buffer_.data() + (line_.begin - base_), std::size_t(line_.end - line_.begin)};
}

std::string_view Lines::text() const {
  std::string_view line = raw();
  if (line.ends_with('\n')) line.remove_suffix(1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

bool Lines::more() {
  buffer_.erase(buffer_.begin(), buffer_.begin() + std::ptrdiff_t(keep_ - base_));
  base_ = keep_;
  const std::size_t old = buffer_.size();
  const std::uint64_t left = size_ - base_ - old; // a file that grows meanwhile ends where it did
  if (left == 0) return false;
  const std::size_t wanted = std::size_t(std::min<std::uint64_t>(chunk, left));
  buffer_.resize(old + wanted);
  stream_->read(buffer_.data() + old, std::streamsize(wanted));
  buffer_.resize(old + std::size_t(stream_->gcount()));
  if (buffer_.size() - old != wanted) fail("", "reading the file failed", "a readable file");
  return true;
}

bool Lines::find_line() {
  std::uint64_t from = cursor_;
  while (true) {
    const std::size_t have = std::size_t(base_ + buffer_.size() - from);
    const char* const start = buffer_.data() + (from - base_);
    if (const void* end = have == 0 ? nullptr : std::memchr(start, '\n', have)) {
      line_ = {cursor_, from + std::uint64_t(static_cast<const char*>(end) - start) + 1,
               line_.number + 1};
      cursor_ = line_.end;
      return true;
    }
    from += have;
    if (from - cursor_ > longest_line)
      fail_at(line_.number + 1, "", "the line is longer than 64 MiB", "a universal file");
    if (!more()) break;
  }
  if (from == cursor_) return false;
  line_ = {cursor_, from, line_.number + 1};
  cursor_ = from;
  return true;
}

bool Lines::next() {
  keep_ = std::max(base_, std::min(line_.begin, cursor_)); // the last line stays at the end
  return find_line();
}

void Lines::back() {
  cursor_ = line_.begin;
  --line_.number;
}

bool Lines::next_with_text() {
  while (find_line())
    if (!is_blank(text())) return true;
  return false;
}

std::string Lines::peek() {
  const Line line = line_;
  const std::uint64_t cursor = cursor_;
  keep_ = std::max(base_, std::min(line.begin, cursor));
  std::string found = next_with_text() ? std::string(text()) : std::string();
  line_ = line;
  cursor_ = cursor;
  return found;
}

bool Lines::ends_set(Wanted wanted) {
  if (!is_delimiter(text())) return false;
  if (wanted == Wanted::nothing) return true;
  const bool as_opened = is_exact_delimiter(text()) || !exact_columns_;
  if (wanted == Wanted::anything && as_opened) return true;
  const Line line = line_;
  const std::uint64_t cursor = cursor_;
  keep_ = line.begin;
  bool ends = true;
  if (next_with_text()) {
    if (is_delimiter(text())) // of the next data set, if the number of one follows
      ends = (next_with_text() && data_set_number(text()).has_value()) || as_opened;
    else
      ends = wanted == Wanted::numbers && !is_numeric(text());
  }
  line_ = line;
  cursor_ = cursor;
  return ends;
}

void Lines::seek(std::uint64_t offset) {
  if (offset >= base_ && offset <= base_ + buffer_.size()) {
    cursor_ = offset;
  } else {
    stream_->clear();
    stream_->seekg(std::streamoff(offset));
    buffer_.clear();
    base_ = keep_ = cursor_ = offset;
  }
  keep_ = cursor_;
}

std::string Lines::bytes(std::uint64_t count) {
  std::string data;
  data.reserve(std::size_t(std::min(count, remaining())));
  keep_ = cursor_;
  while (data.size() < count) {
    const std::uint64_t have = base_ + buffer_.size() - cursor_;
    const std::size_t take = std::size_t(std::min<std::uint64_t>(have, count - data.size()));
    data.append(buffer_.data() + (cursor_ - base_), take);
    cursor_ += take;
    keep_ = cursor_;
    if (data.size() < count && !more())
      fail("", "the file ends inside of binary data", "a whole file");
  }
  // Editors and grep count the line ends among the binary data, so do our line numbers.
  line_ = {cursor_, cursor_, line_.number + int(std::count(data.begin(), data.end(), '\n'))};
  return data;
}

bool Lines::closes_behind(std::uint64_t skip) {
  constexpr std::uint64_t window = 256; // blanks of a padded line
  const std::uint64_t cursor = cursor_;
  const Line line = line_;
  if (skip > remaining()) return false;
  seek(cursor + skip);
  while (base_ + buffer_.size() < cursor_ + window && more()) {
  }
  const std::string_view tail{buffer_.data() + (cursor_ - base_),
                              std::size_t(base_ + buffer_.size() - cursor_)};
  const std::size_t first = tail.find_first_not_of(" \t\r\n");
  const bool closes = first == std::string_view::npos
                          ? cursor_ + tail.size() == size_
                          : is_delimiter(tail.substr(first, tail.find('\n', first) - first));
  seek(cursor);
  line_ = line;
  return closes;
}

void Lines::begin_set(const std::string& name, bool exact_columns) {
  set_ = name;
  exact_columns_ = exact_columns;
}

void Lines::fail(const std::string& record, const std::string& wrong,
                 const std::string& allowed) const {
  fail_at(line_.number, record, wrong, allowed);
}

void Lines::fail_at(int line, const std::string& record, const std::string& wrong,
                    const std::string& allowed) const {
  std::string key = set_.empty() ? "" : "data set " + set_;
  if (!record.empty()) key += (key.empty() ? "" : ", ") + record;
  throw InputError({{.file = name_, .line = line, .key = key, .wrong = wrong, .allowed = allowed}});
}

} // namespace plica::universal

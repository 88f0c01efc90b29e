// Lines and raw bytes of a universal file in one pass. Memory: one buffer of 256 kB, more only for
// a line that is longer.
//
// The closing -1 is a line of its own. Writers differ in its columns, and data or an id line may be
// -1 as well, so that it takes the lines behind it to tell (ends_set).
#pragma once

#include "io/universal/file.hpp"

#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace plica::universal {

class Lines {
public:
  explicit Lines(const std::filesystem::path& path);
  Lines(std::unique_ptr<std::istream> stream, std::uint64_t size, std::string name);

  // Moves to the next line; false at the end of the file.
  bool next();
  // The line without its end and without a carriage return, valid until next(), bytes() or
  // closes_behind().
  std::string_view text() const;
  // The line with its end.
  std::string_view raw() const;
  int number() const { return line_.number; } // of the line, from 1
  // next() gives the current line once more.
  void back();
  // The next line that is not blank without moving there; empty at the end of the file.
  std::string peek();

  // Exactly these bytes behind the current line; the file holds that many, see remaining().
  std::string bytes(std::uint64_t count);
  // Whether, behind `skip` bytes more, only blanks come before a -1 or the end of the file.
  bool closes_behind(std::uint64_t skip);
  std::uint64_t remaining() const { return size_ - cursor_; }

  // What the data set may still hold where the current line stands; anything: its records are not
  // known.
  enum class Wanted { nothing, numbers, text, anything };
  // Whether the current line closes the data set.
  bool ends_set(Wanted wanted);

  // The data set that errors name, and whether its opening -1 stands in columns 5 and 6.
  void begin_set(const std::string& name, bool exact_columns);

  // Throws InputError with the current line. The record is empty, "record 7", ...
  [[noreturn]] void fail(const std::string& record, const std::string& wrong,
                         const std::string& allowed) const;
  [[noreturn]] void fail_at(int line, const std::string& record, const std::string& wrong,
                            const std::string& allowed) const;

private:
  // Offsets in the file, so that they stay true when the buffer moves on.
  struct Line {
    std::uint64_t begin = 0, end = 0; // end: behind the line end
    int number = 0;
  };
  bool find_line();
  bool more(); // reads on, false at the end of the file
  void seek(std::uint64_t offset);
  bool next_with_text();

  std::unique_ptr<std::istream> stream_;
  std::uint64_t size_ = 0;
  std::string name_, set_;
  bool exact_columns_ = true;
  std::vector<char> buffer_;
  std::uint64_t base_ = 0;   // offset of buffer_[0]
  std::uint64_t cursor_ = 0; // where the next line begins
  std::uint64_t keep_ = 0;   // the buffer holds everything from here on
  Line line_;
};

bool is_blank(std::string_view text);
// A line that is nothing but -1; exact: in columns 5 and 6, as the standard says.
bool is_delimiter(std::string_view line);
bool is_exact_delimiter(std::string_view line);

} // namespace plica::universal

#include "io/decks/op4_file.hpp"

#include "io/decks/keywords.hpp"
#include "io/decks/nastran_cards.hpp"
#include "io/files/files.hpp"
#include "words/short_text.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr long most_rows = 2000;         // of a matrix that is taken
constexpr long beyond_counts = 1L << 30; // no matrix has so many rows

struct Head {
  long columns = 0,
       rows = 0; // rows below zero: strings of a sparse matrix have two words before them
  int type = 0;  // 1, 2 real, 3, 4 complex, in single, double precision
  std::string name;
  bool complex() const { return type > 2; }
  bool big() const { return rows < 0 || rows >= 65536; }
};

// Where a string of a sparse column begins and how many words it has, from the integers before it:
// one, or two of a large matrix.
struct String {
  long row = 0, words = 0;
};
String string_of(const Head& head, const std::array<long, 2>& ints) {
  if (head.big()) return {ints[1], ints[0] - 1};
  const long words = (ints[0] >> 16) - 1;
  return {ints[0] - ((words + 1) << 16), words};
}

class Op4Reader {
public:
  Op4Reader(const std::filesystem::path& file, const std::set<std::string>& wanted)
      : file_(file.string()), wanted_(wanted) {}
  virtual ~Op4Reader() = default;

  std::map<std::string, MatrixXd> read() {
    for (Head head; next_head(head);) {
      matrix_ = in_capitals(head.name);
      if (head.columns < 0 || std::abs(head.rows) > beyond_counts || head.columns > beyond_counts ||
          head.type < 1 || head.type > 4)
        bad("has no head of a matrix", "columns, rows, form and type of one");
      const bool taken = wanted_.contains(matrix_);
      if (taken && found_.contains(matrix_)) bad("is there twice", "a name once");
      if (taken) prepare(head);
      read_columns(head, taken);
      if (taken) found_[matrix_] = A_;
    }
    return std::move(found_);
  }

protected:
  virtual bool next_head(Head& head) = 0;
  virtual void read_columns(const Head& head, bool taken) = 0;
  [[noreturn]] void bad(const std::string& wrong, const std::string& allowed) const {
    deck_error({file_, line_}, matrix_.empty() ? "OP4" : "OP4 " + matrix_, wrong, allowed);
  }
  [[noreturn]] void cut() const { bad("ends within a matrix", "a whole file"); }
  void put(long row, long column, double value) {
    if (row < 1 || row > A_.rows() || column < 1 || column > A_.cols())
      bad("has a number in row " + std::to_string(row) + ", column " + std::to_string(column),
          std::to_string(A_.rows()) + " rows, " + std::to_string(A_.cols()) + " columns");
    if (!std::isfinite(value)) bad("has a number that is not finite", "finite numbers");
    A_(row - 1, column - 1) = value;
  }

  std::string file_;
  int line_ = 0; // of a text

private:
  void prepare(const Head& head) {
    if (head.complex()) bad("is complex", "a real matrix");
    if (std::abs(head.rows) > most_rows || head.columns > most_rows)
      bad("has " + std::to_string(std::abs(head.rows)) + " rows and " +
              std::to_string(head.columns) + " columns",
          "at most " + std::to_string(most_rows));
    A_ = MatrixXd::Zero(std::abs(head.rows), head.columns);
  }

  const std::set<std::string>& wanted_;
  std::map<std::string, MatrixXd> found_;
  std::string matrix_;
  MatrixXd A_;
};

// Heads and heads of columns in fields of eight, numbers as the head says: 1P,5E16.9.
class TextReader : public Op4Reader {
public:
  TextReader(const std::filesystem::path& file, const std::set<std::string>& wanted,
             std::string text)
      : Op4Reader(file, wanted), stream_(std::move(text)) {}

private:
  bool next_head(Head& head) override {
    do
      if (!next()) return false;
    while (trimmed(text_).empty());
    constexpr std::size_t small = 8, large = 16;
    const bool wide = text_.ends_with("|I16"); // the counts of rows and columns
    const std::size_t width = wide ? large : small, behind = 2 * width;
    head.columns = whole(0, width);
    head.rows = whole(width, width);
    head.type = int(whole(behind + small, small));
    head.name = field(behind + 2 * small, small);
    std::string form = in_capitals(text_.substr(std::min(text_.size(), behind + 3 * small)));
    if (form.starts_with("1P,")) form.erase(0, 3);
    const auto letter = form.find_first_of("ED");
    per_line_ = 5;
    width_ = large;
    if (letter == std::string::npos) return true;
    per_line_ = number_in(form.substr(0, letter));
    width_ = std::size_t(number_in(form.substr(letter + 1, form.find('.') - letter - 1)));
    return true;
  }

  void read_columns(const Head& head, bool taken) override {
    while (true) {
      if (!next()) cut();
      const long column = whole(0, 8), row = whole(8, 8);
      long words = whole(16, 8);
      if (column < 1 || column > head.columns + 1 || row < 0 || words < 0)
        bad("has no head of a column", "column, first row and number of words");
      if (column > head.columns) {
        if (words > 0 && !next()) cut();
        return;
      }
      if (row > 0) {
        numbers(row, column, head.complex() ? 0 : words, words, taken);
        continue;
      }
      while (words > 0) {
        if (!next()) cut();
        const String s =
            string_of(head, {whole(0, head.big() ? 8 : 16), head.big() ? whole(8, 8) : 0});
        if (s.words < 1) bad("has no head of a string", "its length and first row");
        words -= s.words + (head.big() ? 2 : 1);
        const long reals = s.words / (head.type % 2 == 0 ? 2 : 1);
        numbers(s.row, column, reals, reals, taken);
      }
    }
  }

  void numbers(long row, long column, long put_down, long count, bool taken) {
    for (long k = 0; k < count; ++k) {
      if (k % per_line_ == 0 && !next()) cut();
      if (taken && k < put_down) put(row + k, column, real(width_ * std::size_t(k % per_line_)));
    }
  }

  bool next() {
    ++line_;
    if (!std::getline(stream_, text_)) return false;
    while (text_.ends_with('\r') || text_.ends_with(' ')) text_.pop_back();
    return true;
  }
  std::string field(std::size_t at, std::size_t size) const {
    return at < text_.size() ? std::string(trimmed(text_.substr(at, size))) : "";
  }
  long whole(std::size_t at, std::size_t size) const {
    const auto value = whole_number_of(field(at, size));
    if (!value) bad("has \"" + field(at, size) + "\" for a count", "a whole number");
    return *value;
  }
  int number_in(const std::string& text) const {
    const auto value = whole_number_of(trimmed(text));
    if (!value || *value < 1 || *value > 100) bad("has no form of its numbers", "1P,5E16.9");
    return *value;
  }
  double real(std::size_t at) const {
    try {
      return nastran_number(field(at, width_));
    } catch (const std::logic_error&) {
      bad("has \"" + field(at, width_) + "\" for a number", "a number");
    }
  }

  std::istringstream stream_;
  std::string text_;
  int per_line_ = 5;
  std::size_t width_ = 16;
};

// Records between their lengths, as Fortran writes them.
class BinaryReader : public Op4Reader {
public:
  BinaryReader(const std::filesystem::path& file, const std::set<std::string>& wanted,
               const std::string& bytes, std::size_t word, bool swapped)
      : Op4Reader(file, wanted), bytes_(bytes), word_(word), swapped_(swapped) {}

private:
  bool next_head(Head& head) override {
    if (at_ == bytes_.size()) return false;
    if (!next_record() || record_.size() < 6 * word_) cut();
    head.columns = integer(0);
    head.rows = integer(1);
    head.type = int(integer(3));
    head.name = trimmed(std::string(record_.substr(4 * word_, 2 * word_)));
    return true;
  }

  void read_columns(const Head& head, bool taken) override {
    while (true) {
      if (!next_record() || record_.size() < 3 * word_) cut();
      const long column = integer(0), row = integer(1);
      if (column < 1 || column > head.columns + 1)
        bad("has no head of a column", "column, first row and number of words");
      if (column > head.columns) return;
      if (!taken) continue;
      std::size_t at = 3; // in words
      const std::size_t end = at + std::size_t(std::max(0L, integer(2)));
      if (row > 0) {
        numbers(head, {row, long(end - at)}, at, column);
        continue;
      }
      while (at < end) {
        const String s = string_of(head, {integer(at), head.big() ? integer(at + 1) : 0});
        at += head.big() ? 2 : 1;
        if (s.words < 1) bad("has no head of a string", "its length and first row");
        numbers(head, s, at, column);
        at += std::size_t(s.words);
      }
    }
  }

  void numbers(const Head& head, const String& s, std::size_t at, long column) {
    const bool is_double = head.type % 2 == 0 || word_ == 8;
    const std::size_t size = is_double ? 8 : 4;
    const long count = s.words * long(word_) / long(size);
    for (long k = 0; k < count; ++k) {
      const std::string_view raw = raw_bytes(at * word_ + std::size_t(k) * size, size);
      put(s.row + k, column,
          is_double ? value_of<double, std::uint64_t>(raw) : value_of<float, std::uint32_t>(raw));
    }
  }

  template <class Value, class Bits> Value value_of(std::string_view raw) const {
    Bits bits = 0;
    for (std::size_t i = 0; i < sizeof(Bits); ++i)
      bits |= Bits(std::uint8_t(raw[swapped_ ? sizeof(Bits) - 1 - i : i])) << (8 * i);
    return std::bit_cast<Value>(bits);
  }
  std::string_view raw_bytes(std::size_t at, std::size_t size) const {
    if (at + size > record_.size()) cut();
    return record_.substr(at, size);
  }
  long integer(std::size_t word) const {
    const std::string_view raw = raw_bytes(word * word_, word_);
    return word_ == 8 ? long(value_of<std::int64_t, std::uint64_t>(raw))
                      : long(value_of<std::int32_t, std::uint32_t>(raw));
  }
  bool next_record() {
    constexpr std::size_t mark = 4;
    const auto length_at = [&](std::size_t at) {
      return value_of<std::int32_t, std::uint32_t>(std::string_view(bytes_).substr(at, mark));
    };
    if (at_ + mark > bytes_.size()) return false;
    const std::int32_t length = length_at(at_);
    const std::size_t left = bytes_.size() - at_ - mark;
    if (length < 0 || left < mark || std::size_t(length) > left - mark) return false;
    record_ = std::string_view(bytes_).substr(at_ + mark, std::size_t(length));
    at_ += mark + std::size_t(length);
    if (length_at(at_) != length) return false;
    at_ += mark;
    return true;
  }

  const std::string& bytes_;
  std::size_t word_ = 4, at_ = 0;
  bool swapped_ = false;
  std::string_view record_;
};

} // namespace

std::map<std::string, MatrixXd> read_op4_file(const std::filesystem::path& file,
                                              const std::set<std::string>& wanted) {
  if (const std::string why = why_unreadable(file); !why.empty())
    deck_error({file.string(), 0}, "OP4", why, "a file of OUTPUT4");
  const std::string bytes = read_whole(file);
  // The head of a binary file has six words of four or of eight bytes.
  for (const char word : {char(4), char(8)})
    for (const bool swapped : {false, true}) {
      std::string length{char(6 * word), 0, 0, 0};
      if (swapped) length = std::string{0, 0, 0, char(6 * word)};
      if (bytes.starts_with(length))
        return BinaryReader(file, wanted, bytes, std::size_t(word), swapped).read();
    }
  return TextReader(file, wanted, bytes).read();
}

} // namespace plica

#include "io/matlab/matlab5_elements.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

namespace plica {
namespace {

constexpr std::size_t header = 128;
constexpr std::uint32_t matrix_type = 14, compressed_type = 15, deepest = 32;

struct Element {
  std::uint32_t type = 0;
  std::size_t begin = 0, size = 0; // of its data
  std::size_t next = 0;            // behind it and what fills it up to eight bytes
};

// Bytes of a number of a type; 0 of what holds none.
std::size_t bytes_of(std::uint32_t type) {
  switch (type) {
  case 1: // int8, uint8, UTF-8
  case 2:
  case 16:
    return 1;
  case 3: // int16, uint16, UTF-16
  case 4:
  case 17:
    return 2;
  case 5: // int32, uint32, single, UTF-32
  case 6:
  case 7:
  case 18:
    return 4;
  case 9: // double, int64, uint64
  case 12:
  case 13:
    return 8;
  default:
    return 0;
  }
}

class Frame {
public:
  explicit Frame(const std::string& bytes) : bytes_(bytes) {
    constexpr std::size_t marks = 126;
    const bool little = bytes.compare(marks, 2, "IM") == 0;
    swap_ = little != (std::endian::native == std::endian::little);
  }

  std::string fault() {
    for (std::size_t at = header; at < bytes_.size() && fault_.empty();) {
      const Element e = element(at, bytes_.size());
      if (fault_.empty() && e.type != matrix_type && e.type != compressed_type)
        say(at, "type " + std::to_string(e.type) + " where a variable is due");
      if (fault_.empty() && e.type == matrix_type) array(e, 0);
      // What is compressed has a sum of its own, and nothing fills it up.
      at = e.type == compressed_type ? e.begin + e.size : e.next;
    }
    return fault_;
  }

private:
  void say(std::size_t at, const std::string& what) {
    if (fault_.empty()) fault_ = "at byte " + std::to_string(at) + ", " + what;
  }

  std::uint32_t word(std::size_t at) const {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes_.data() + at, sizeof value);
    return swap_ ? __builtin_bswap32(value) : value;
  }

  // That begins at a byte and has to end before another.
  Element element(std::size_t at, std::size_t end) {
    constexpr std::size_t tag = 8;
    if (at + tag > end) {
      say(at, "the file ends inside of a tag");
      return {.next = end};
    }
    const std::uint32_t first = word(at);
    Element e;
    if (first >> 16 != 0) { // at most four bytes, in the tag itself
      e = {first & 0xffff, at + 4, first >> 16, at + tag};
      if (e.size > 4) say(at, "a small element of " + std::to_string(e.size) + " bytes");
    } else {
      e = {first, at + tag, word(at + 4), 0};
      e.next = e.begin + (e.size + 7) / 8 * 8;
    }
    if (e.begin + e.size > end)
      say(at, "an element of " + std::to_string(e.size) + " bytes, " +
                  std::to_string(end - e.begin) + " are there");
    e.next = std::min(e.next, end);
    return e;
  }

  // Flags, dimensions, name, then numbers, or the arrays of a structure or a cell.
  void array(const Element& whole, std::uint32_t depth) {
    const std::size_t end = whole.begin + whole.size;
    if (whole.size == 0 || depth > deepest) return; // an empty cell
    const Element flags = element(whole.begin, end);
    constexpr std::uint32_t function_handle = 16; // and objects, which have other parts
    if (fault_.empty() && flags.type == 6 && flags.size == 8 &&
        (word(flags.begin) & 0xff) >= function_handle)
      return;
    const Element dimensions = element(flags.next, end);
    const Element name = element(dimensions.next, end);
    if (!fault_.empty()) return;
    if (flags.type != 6 || flags.size != 8 || dimensions.type != 5 || dimensions.size % 4 != 0 ||
        bytes_of(name.type) != 1)
      return say(whole.begin, "a variable without flags, dimensions and name");
    const std::uint32_t kind = word(flags.begin) & 0xff;
    const bool complex = (word(flags.begin) & 0x800) != 0;
    double count = 1;
    for (std::size_t i = 0; i < dimensions.size; i += 4)
      count *= double(std::int32_t(word(dimensions.begin + i)));
    constexpr std::uint32_t first_numeric = 6, last_numeric = 15, text = 4;
    const bool numbers = (kind >= first_numeric && kind <= last_numeric) || kind == text;
    std::size_t at = name.next;
    for (int part = 0; numbers && part < (complex ? 2 : 1) && fault_.empty(); ++part) {
      const Element e = element(at, end);
      const std::size_t each = bytes_of(e.type);
      // UTF-8 may take more than one byte for a letter.
      if (fault_.empty() && kind != text && (each == 0 || double(e.size) != count * double(each)))
        say(at, "a variable of other size than its dimensions say");
      at = e.next;
    }
    if (numbers && fault_.empty() && at != end) say(at, "more than the numbers of a variable");
    while (!numbers && at < end && fault_.empty()) {
      const Element e = element(at, end);
      if (fault_.empty() && e.type == matrix_type) array(e, depth + 1);
      at = e.next;
    }
  }

  const std::string& bytes_;
  bool swap_ = false;
  std::string fault_;
};

} // namespace

std::string fault_of_matlab5(const std::string& bytes) {
  if (bytes.size() < header) return "the file ends inside of its header";
  return Frame(bytes).fault();
}

} // namespace plica

#include "io/universal/fields.hpp"

#include "words/input_error.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace plica::universal {

Fields::Fields(std::string set, const std::string& number_line)
    : set_(std::move(set)), text_("    -1\n" + number_line + "\n") {}

Fields& Fields::record(int number) {
  record_ = number;
  return *this;
}

void Fields::fail(const std::string& wrong, const std::string& allowed) const {
  const std::string record = record_ > 0 ? ", record " + std::to_string(record_) : "";
  input_error("data set " + set_ + record, wrong, allowed);
}

Fields& Fields::whole(long value, int width) {
  const std::string digits = std::to_string(value);
  if (int(digits.size()) > width)
    fail(digits + " is too wide", "an integer of at most " + std::to_string(width) + " columns");
  text_.append(std::size_t(width) - digits.size(), ' ');
  text_ += digits;
  return *this;
}

Fields& Fields::name(const std::string& text, int width) {
  if (int(text.size()) > width || text.find_first_of("\r\n\t") != std::string::npos)
    fail("'" + text + "' does not fit",
         "one line of at most " + std::to_string(width) + " characters without tabs");
  text_ += text;
  text_.append(std::size_t(width) - text.size(), ' ');
  return *this;
}

Fields& Fields::real(double value, int width, int decimals, char letter) {
  if (!std::isfinite(value)) fail("a number is NaN or infinite", "finite numbers");
  std::array<char, 40> digits;
  const std::ptrdiff_t longest = std::signbit(value) ? width : width - 1;
  char* end = nullptr;
  do {
    end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                        std::chars_format::scientific, decimals)
              .ptr;
  } while (end - digits.data() > longest && --decimals > 0);
  *std::find(digits.data(), end, 'e') = letter;
  text_.append(std::size_t(width - (end - digits.data())), ' ');
  text_.append(digits.data(), end);
  return *this;
}

Fields& Fields::abscissa(double value) {
  constexpr int width = 13, decimals = 5;
  const std::size_t before = text_.size();
  real(value, width, decimals + 1);
  const std::size_t last = text_.find('E', before) - 1; // the sixth decimal
  if (text_[before] == ' ' && text_[last] != '0') return *this;
  text_.resize(before);
  return real(value, width, decimals);
}

Fields& Fields::id(const std::string& text) {
  if (text.find_first_of("\r\n") != std::string::npos) fail("an id has line ends", "one line");
  text_ += text;
  return end_line();
}

Fields& Fields::end_line() {
  text_ += '\n';
  return *this;
}

Fields& Fields::bytes(const std::string& data) {
  text_ += data;
  return *this;
}

} // namespace plica::universal

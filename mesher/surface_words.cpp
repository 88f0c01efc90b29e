#include "mesher/surface_words.hpp"

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace plica {

void surface_error(int line, const std::string& wrong) {
  throw std::runtime_error((line > 0 ? "line " + std::to_string(line) + ": " : "") + wrong);
}

std::string shown_word(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text = "'";
  for (const char c : word.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + "'";
}

std::vector<TextLine> lines_of_words(std::string_view text) {
  std::vector<TextLine> lines;
  int number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    TextLine line{.number = ++number, .words = {}};
    const std::string_view whole = text.substr(at, end - at);
    if (whole.find('\0') != std::string_view::npos)
      surface_error(number, "holds a byte of zero: the file is damaged, or no text");
    for (std::size_t i = 0; i < whole.size();) {
      const std::size_t first = std::min(whole.find_first_not_of(" \t", i), whole.size());
      const std::size_t last = std::min(whole.find_first_of(" \t", first), whole.size());
      if (last > first) line.words.push_back(whole.substr(first, last - first));
      i = last;
    }
    lines.push_back(std::move(line));
    const bool both = text.substr(end, 2) == "\r\n";
    at = end + (both ? 2 : 1);
  }
  return lines;
}

double finite_number(const TextLine& line, std::size_t word) {
  if (word >= line.words.size()) surface_error(line.number, "has a number too few");
  std::string_view text = line.words[word];
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool small = error == std::errc::result_out_of_range && text.find("e-") != text.npos;
  if ((error != std::errc() && !small) || end != text.data() + text.size() || !std::isfinite(value))
    surface_error(line.number, shown_word(text) + " is no finite number");
  return value;
}

long whole_number(const TextLine& line, std::string_view word) {
  long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    surface_error(line.number, shown_word(word) + " is no whole number");
  return value;
}

} // namespace plica

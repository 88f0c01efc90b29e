#include "tests/damaged/damage.hpp"

#include "io/lab_files/lab_units.hpp"
#include "tests/mutator.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

namespace plica::test {
namespace {

std::vector<std::string> lines_of_file(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    lines.push_back(text.substr(at, end - at));
    at = end;
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

class Breaker {
public:
  explicit Breaker(unsigned seed) : any_(seed) {}

  std::string once(std::string& text) {
    using Kind = std::pair<const char*, void (Breaker::*)(std::string&)>;
    static constexpr std::array kinds{Kind{"line deleted", &Breaker::delete_line},
                                      Kind{"line duplicated", &Breaker::duplicate_line},
                                      Kind{"lines swapped", &Breaker::swap_lines},
                                      Kind{"section dropped", &Breaker::drop_section},
                                      Kind{"cut", &Breaker::cut},
                                      Kind{"field garbled", &Breaker::garble_field},
                                      Kind{"number replaced", &Breaker::replace_number},
                                      Kind{"digit changed", &Breaker::change_digit},
                                      Kind{"byte flipped", &Breaker::flip},
                                      Kind{"bytes missing", &Breaker::drop_bytes},
                                      Kind{"zeros in a block", &Breaker::zero_block},
                                      Kind{"line ends changed", &Breaker::change_line_ends},
                                      Kind{"marked as Unicode", &Breaker::mark},
                                      Kind{"written as UTF-16", &Breaker::widen},
                                      Kind{"mixed", &Breaker::mix}};
    const auto& [name, work] = kinds[any_.below(kinds.size())];
    (this->*work)(text);
    return name;
  }

private:
  void by_lines(std::string& text, const std::function<void(std::vector<std::string>&)>& work) {
    std::vector<std::string> lines = lines_of_file(text);
    if (!lines.empty()) work(lines);
    text = joined(lines);
  }
  std::ptrdiff_t any_of(const std::vector<std::string>& lines) {
    return std::ptrdiff_t(any_.below(lines.size()));
  }
  void delete_line(std::string& text) {
    by_lines(text, [&](auto& lines) { lines.erase(lines.begin() + any_of(lines)); });
  }
  void duplicate_line(std::string& text) {
    by_lines(text, [&](auto& lines) {
      const auto at = any_of(lines);
      lines.insert(lines.begin() + at, std::string(lines[std::size_t(at)]));
    });
  }
  void swap_lines(std::string& text) {
    by_lines(text, [&](auto& lines) {
      std::swap(lines[any_.below(lines.size())], lines[any_.below(lines.size())]);
    });
  }
  void drop_section(std::string& text) {
    by_lines(text, [&](auto& lines) {
      const auto first = any_of(lines);
      const auto count = 1 + std::ptrdiff_t(any_.below(1 + lines.size() / 4));
      lines.erase(lines.begin() + first,
                  lines.begin() + std::min(first + count, std::ptrdiff_t(lines.size())));
    });
  }
  void cut(std::string& text) { text.resize(any_.below(text.size())); }
  static bool is_separator(char c) {
    return std::string(" \t\r\n,;:=[]{}()\"'").find(c) != std::string::npos;
  }
  // Begin and length of the field at or behind a place.
  std::pair<std::size_t, std::size_t> field(const std::string& text) {
    std::size_t begin = any_.below(text.size());
    while (begin < text.size() && is_separator(text[begin])) ++begin;
    while (begin > 0 && begin < text.size() && !is_separator(text[begin - 1])) --begin;
    std::size_t end = begin;
    while (end < text.size() && !is_separator(text[end])) ++end;
    return {begin, end - begin};
  }
  void garble_field(std::string& text) {
    const auto [begin, length] = field(text);
    constexpr std::array<const char*, 10> garbage{"x", "1.2.3", "--5", "0x1F", "#",
                                                  "*", "1,2",   "$$",  "\"",   "\xff\xfe"};
    if (length > 0) text.replace(begin, length, garbage[any_.below(garbage.size())]);
  }
  void replace_number(std::string& text) {
    const std::size_t from = text.find_first_of("0123456789", any_.below(text.size()));
    if (from == std::string::npos) return;
    const std::size_t end = text.find_first_not_of("0123456789.eE+-", from);
    constexpr std::array<const char*, 9> numbers{"nan", "inf",   "-inf", "1e999",     "",
                                                 "0",   "1e300", "-1",   "9999999999"};
    text.replace(from, std::min(end, text.size()) - from, numbers[any_.below(numbers.size())]);
  }
  void change_digit(std::string& text) {
    const std::size_t at = text.find_first_of("0123456789", any_.below(text.size()));
    if (at != std::string::npos) text[at] = char('0' + any_.below(10));
  }
  void flip(std::string& text) {
    if (text.empty()) return;
    char& c = text[any_.below(text.size())];
    c = char(c ^ (1 << any_.below(8)));
  }
  void drop_bytes(std::string& text) { text.erase(any_.below(text.size()), 1 + any_.below(20)); }
  void zero_block(std::string& text) {
    const std::size_t at = any_.below(text.size());
    const std::size_t count = std::min(text.size() - at, 1 + any_.below(64));
    std::fill_n(text.begin() + std::ptrdiff_t(at), count, '\0');
  }
  void change_line_ends(std::string& text) {
    replace_all(text, "\n", any_.below(2) == 0 ? "\r\n" : "\r");
  }
  void mark(std::string& text) {
    constexpr std::array<const char*, 3> marks{"\xef\xbb\xbf", "\xff\xfe", "\xfe\xff"};
    text.insert(0, marks[any_.below(marks.size())]);
  }
  void widen(std::string& text) {
    std::string wide = "\xff\xfe";
    for (const char c : text) (wide += c) += '\0';
    text = wide;
  }
  void mix(std::string& text) { any_.damage(text); }

  Mutator any_;
};

// --- another good file

std::vector<std::string> tokens_of(std::string line, char comment) {
  if (comment != '\0') line.resize(std::min(line.find(comment), line.size()));
  std::vector<std::string> tokens;
  std::string token;
  for (const char c : line + ' ') {
    if (std::string(" \t\r\n,;:=[]{}()\"'/").find(c) == std::string::npos) {
      token += char(std::tolower(static_cast<unsigned char>(c)));
    } else if (!token.empty()) {
      tokens.push_back(std::exchange(token, ""));
    }
  }
  return tokens;
}

// Finite, in the notations of all formats: 1.5e3, 1.5D+3, 1.5+3, 25.
bool is_number(std::string text) {
  if (text.starts_with('+')) text.erase(0, 1);
  for (char& c : text)
    if (c == 'D' || c == 'd' || c == 'E') c = 'e';
  const std::size_t sign = text.find_first_of("+-", 1);
  if (sign != std::string::npos && text.find('e') == std::string::npos) text.insert(sign, "e");
  if (const auto plus = text.find("e+"); plus != std::string::npos) text.erase(plus + 1, 1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

bool is_word_of(const std::string& token, const std::set<std::string>& words) {
  return words.contains(token) || lab_unit(token).has_value();
}

// "5mm" is a number and a unit.
bool is_number_with_word(const std::string& token, const std::set<std::string>& words) {
  for (std::size_t cut = 1; cut < token.size(); ++cut)
    if (is_number(token.substr(0, cut)) && is_word_of(token.substr(cut), words)) return true;
  return false;
}

bool reads_alike(const std::vector<std::string>& now, const std::vector<std::string>& once,
                 const std::set<std::string>& words) {
  if (now.size() > once.size()) return false;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (now[i] != once[i] && !is_number(now[i]) && !is_word_of(now[i], words) &&
        !is_number_with_word(now[i], words))
      return false;
  return true;
}

bool good_text(const std::string& original, const std::string& damaged, const FormatRule& rule) {
  std::vector<std::vector<std::string>> once;
  std::set<std::string> words;
  for (const std::string& line : lines_of_file(original)) {
    once.push_back(tokens_of(line, rule.comment));
    words.insert(once.back().begin(), once.back().end());
  }
  const std::vector<std::string> lines = lines_of_file(damaged);
  if (rule.chained && lines.size() != once.size()) return false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::vector<std::string> now = tokens_of(lines[i], rule.comment);
    const auto alike = [&](const auto& line) { return reads_alike(now, line, words); };
    if (rule.chained ? !alike(once[i]) : std::none_of(once.begin(), once.end(), alike))
      return false;
  }
  return true;
}

} // namespace

Damaged damaged(const std::string& original, unsigned seed) {
  Breaker breaker(seed);
  Damaged result{original, ""};
  result.what = breaker.once(result.bytes);
  return result;
}

bool another_good_file(const std::string& original, const std::string& damaged,
                       const FormatRule& rule) {
  if (rule.payload.empty()) return good_text(original, damaged, rule);
  if (original.size() != damaged.size()) return false;
  const auto [begin, end] = rule.text;
  if (!good_text(original.substr(begin, end - begin), damaged.substr(begin, end - begin), rule))
    return false;
  for (std::size_t i = 0; i < original.size(); ++i)
    if (original[i] != damaged[i] && (i < begin || i >= end) &&
        std::none_of(rule.payload.begin(), rule.payload.end(),
                     [&](const auto& range) { return i >= range.first && i < range.second; }))
      return false;
  return true;
}

} // namespace plica::test

// Damages text at random: bytes, numbers, lines. Used by the fuzz tests; PLICA_FUZZ_ROUNDS sets the
// rounds of their slow suites, 300,000 unless told.
#pragma once

#include <cstdlib>
#include <initializer_list>
#include <random>
#include <string>

namespace plica::test {

inline long fuzz_rounds() {
  const char* told = std::getenv("PLICA_FUZZ_ROUNDS");
  return told ? std::atol(told) : 300000;
}

class Mutator {
public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }

  void damage(std::string& text) {
    const std::size_t at = below(text.size());
    switch (below(9)) {
    case 0:
      if (!text.empty()) text[at] = char(below(256));
      break;
    case 1:
      if (!text.empty()) text[at] = char(text[at] ^ (1 << below(8)));
      break;
    case 2:
      text.erase(at, 1 + below(20));
      break;
    case 3:
      text.resize(at);
      break;
    case 4:
      number(text, at);
      break;
    case 5:
      duplicate_line(text, at);
      break;
    case 6:
      erase_line(text, at);
      break;
    case 7:
      text.insert(at, pick({"-1", ";", ",", "\"", "j", "\n", "\n    -1\n", "\n    58\n", " ", "NaN",
                            "\t", "\r", "1E999", "-1.0-2.0", "\n   151\n", "\n58b 1 2 11 8\n"}));
      break;
    default:
      swap_parts(text, at);
    }
  }

private:
  std::string pick(std::initializer_list<const char*> choices) {
    return choices.begin()[below(choices.size())];
  }
  static std::pair<std::size_t, std::size_t> line_at(const std::string& text, std::size_t at) {
    const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    const std::size_t end = text.find('\n', begin);
    return {begin, end == std::string::npos ? text.size() : end + 1};
  }
  void number(std::string& text, std::size_t at) {
    const std::size_t digit = text.find_first_of("0123456789", at);
    if (digit == std::string::npos) return;
    text.replace(digit, 1,
                 pick({"0", "9", "-1", "-7", "99999999999", "2147483647", "1E30", "3", "1000000",
                       "4294967296", ""}));
  }
  void duplicate_line(std::string& text, std::size_t at) {
    const auto [begin, end] = line_at(text, at);
    text.insert(end, text.substr(begin, end - begin));
  }
  void erase_line(std::string& text, std::size_t at) {
    const auto [begin, end] = line_at(text, at);
    text.erase(begin, end - begin);
  }
  void swap_parts(std::string& text, std::size_t at) {
    const std::string part = text.substr(at, below(200));
    text.insert(below(text.size()), part);
  }
  std::mt19937 random_;
};

} // namespace plica::test

#include "words/utf8.hpp"

#include <algorithm>

namespace plica {

bool continues_letter(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
}

std::size_t letter_count(std::string_view text) {
  return text.size() - std::size_t(std::count_if(text.begin(), text.end(), continues_letter));
}

std::size_t utf8_length(std::string_view s, std::size_t i) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(s[k]); };
  const unsigned char c = byte(i);
  if (c < 0x80) return 1;
  const std::size_t length = c >= 0xC2 && c <= 0xDF   ? 2
                             : (c & 0xF0) == 0xE0     ? 3
                             : c >= 0xF0 && c <= 0xF4 ? 4
                                                      : 0;
  if (length == 0 || i + length > s.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if (!continues_letter(s[i + k])) return 0;
  const bool overlong = (c == 0xE0 && byte(i + 1) < 0xA0) || (c == 0xF0 && byte(i + 1) < 0x90);
  const bool beyond = (c == 0xED && byte(i + 1) > 0x9F) || (c == 0xF4 && byte(i + 1) > 0x8F);
  return overlong || beyond ? 0 : length;
}

std::string in_utf8(std::string text) {
  std::size_t i = 0;
  while (i < text.size()) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) break;
    i += length;
  }
  if (i >= text.size()) return text;
  std::string converted;
  for (const char letter : text) {
    const auto c = static_cast<unsigned char>(letter);
    if (c < 0x80) {
      converted += letter;
    } else {
      converted += static_cast<char>(0xC0 | (c >> 6));
      converted += static_cast<char>(0x80 | (c & 0x3F));
    }
  }
  return converted;
}

} // namespace plica

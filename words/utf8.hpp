// Letters of a text in UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace plica {

// True of the bytes of a letter after its first.
bool continues_letter(char byte);

// Letters of a text that is UTF-8.
std::size_t letter_count(std::string_view text);

// Bytes of the letter at i; 0 when it is none.
std::size_t utf8_length(std::string_view text, std::size_t i);

// A text that is no UTF-8 is taken for Latin-1, as older lab software writes it.
std::string in_utf8(std::string text);

} // namespace plica

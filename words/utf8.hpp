// Letters of a text in UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace plica {

// Bytes of the letter at i; 0 when it is none.
std::size_t utf8_length(std::string_view text, std::size_t i);

// A text that is no UTF-8 is taken for Latin-1, as older lab software writes it.
std::string in_utf8(std::string text);

} // namespace plica

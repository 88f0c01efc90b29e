// Words of a text with their lines, for the files of triangles that are texts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plica {

[[noreturn]] void surface_error(int line, const std::string& wrong); // std::runtime_error

struct TextLine {
  int number = 0;
  std::vector<std::string_view> words; // none of a blank line
};

// Lines end at \n, \r\n or \r. A byte of zero is refused.
std::vector<TextLine> lines_of_words(std::string_view text);

double finite_number(const TextLine& line, std::size_t word); // refused where it is none
long whole_number(const TextLine& line, std::string_view word);
std::string shown_word(std::string_view word); // as a message may show it

} // namespace plica

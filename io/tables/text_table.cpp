#include "io/tables/text_table.hpp"

#include "words/utf8.hpp"

#include <algorithm>

namespace plica {

std::string text_table(const TextRows& rows, const std::string& align) {
  std::vector<std::size_t> width;
  for (const auto& row : rows) {
    width.resize(std::max(width.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i)
      width[i] = std::max(width[i], letter_count(row[i]));
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string space(width[i] - letter_count(row[i]), ' ');
      const bool left = align[std::min(i, align.size() - 1)] == '<';
      line += (i == 0 ? "  " : "   ") + (left ? row[i] + space : space + row[i]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

} // namespace plica

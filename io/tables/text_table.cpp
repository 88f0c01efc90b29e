#include "io/tables/text_table.hpp"

#include <algorithm>

namespace plica {
namespace {

// Bytes are letters but for the continuation bytes of UTF-8.
std::size_t letters(const std::string& text) {
  return std::size_t(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

} // namespace

std::string text_table(const TextRows& rows, const std::string& align) {
  std::vector<std::size_t> width;
  for (const auto& row : rows) {
    width.resize(std::max(width.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], letters(row[i]));
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string space(width[i] - letters(row[i]), ' ');
      const bool left = align[std::min(i, align.size() - 1)] == '<';
      line += (i == 0 ? "  " : "   ") + (left ? row[i] + space : space + row[i]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

} // namespace plica

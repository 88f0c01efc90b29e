// Tables for the terminal.
#pragma once

#include <string>
#include <vector>

namespace plica {

// Rows of cells in columns as wide as their widest, indented by two; from column `numbers` on
// right-aligned.
std::string text_table(const std::vector<std::vector<std::string>>& rows, std::size_t numbers);

} // namespace plica

// Tables for the terminal.
#pragma once

#include <string>
#include <vector>

namespace plica {

using TextRows = std::vector<std::vector<std::string>>;

// Rows of cells in columns as wide as their widest, indented by two; rows may be of unequal length.
// `align` has one of '<' (left) and '>' (right) for each column, its last for all columns beyond.
std::string text_table(const TextRows& rows, const std::string& align);

} // namespace plica

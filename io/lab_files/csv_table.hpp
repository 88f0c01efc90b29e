// Tables of numbers as text: commas, semicolons or tabs; decimal point, or decimal comma beside
// semicolons or tabs; complex cells (1.5-2e-3j); quoted cells; comment lines (# or %); with a
// header line or without. Cells are split by libcsv.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace plica {

struct CsvColumn {
  std::string name, unit; // "mid y real", "m/s2" of "mid y real [m/s2]"; empty without header
  Eigen::VectorXd real, imaginary; // the second empty when all cells are real
};

struct CsvTable {
  std::vector<CsvColumn> columns;
  bool header = false;
  int header_line = 0; // in the file
};

// Throws InputError with file, line and column: cells that are no finite numbers, rows of different
// length, no rows.
CsvTable read_csv(const std::filesystem::path& path);

// The same from memory; the name stands in errors.
CsvTable csv_of_text(const std::string& text, const std::filesystem::path& name);

// Cells as they are written, blanks around them cut off.
struct CsvCells {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows; // as wide as the header
};

// Throws InputError as read_csv().
CsvCells read_cells(const std::filesystem::path& path);

} // namespace plica

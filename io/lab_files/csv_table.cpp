#include "io/lab_files/csv_table.hpp"

#include "io/files/files.hpp"
#include "io/lab_files/lab_units.hpp"
#include "words/input_error.hpp"
#include "words/short_text.hpp"
#include "words/utf8.hpp"

#include <csv.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

namespace plica {
namespace {

using Complex = std::complex<double>;
using Row = std::vector<std::string>;

struct Line {
  int number = 0;
  std::string text;
};

[[noreturn]] void bad(const std::filesystem::path& path, int line, const std::string& key,
                      const std::string& wrong, const std::string& allowed) {
  throw InputError({{.file = path.string(),
                     .line = line,
                     .key = key,
                     .wrong = wrong,
                     .allowed = "allowed: " + allowed}});
}

// A number without a blank before it; moves `at` behind it.
std::optional<double> number_at(const char*& at, const char* end) {
  if (at < end && *at == '+') ++at;
  double value = 0;
  const auto [next, error] = std::from_chars(at, end, value);
  if (error != std::errc()) return std::nullopt;
  at = next;
  return value;
}

bool is_unit(const char* at, const char* end) {
  return end - at == 1 && (*at == 'i' || *at == 'j');
}

std::optional<Complex> complex_of(std::string cell, bool decimal_comma) {
  if (decimal_comma) std::replace(cell.begin(), cell.end(), ',', '.');
  if (cell.size() > 1 && cell.front() == '(' && cell.back() == ')')
    cell = trimmed(cell.substr(1, cell.size() - 2));
  std::erase(cell, ' ');
  const char* at = cell.data();
  const char* end = at + cell.size();
  const auto first = number_at(at, end);
  if (!first) return std::nullopt;
  if (at == end) return Complex(*first, 0);
  if (is_unit(at, end)) return Complex(0, *first);
  if (*at != '+' && *at != '-') return std::nullopt;
  const auto second = number_at(at, end);
  if (!second || !is_unit(at, end)) return std::nullopt;
  return Complex(*first, *second);
}

std::vector<Line> lines_of(const std::string& text) {
  std::vector<Line> lines;
  std::istringstream stream(text);
  Line line;
  while (std::getline(stream, line.text)) {
    ++line.number;
    if (line.number == 1 && line.text.starts_with("\xef\xbb\xbf")) line.text.erase(0, 3);
    line.text = trimmed(line.text);
    if (!line.text.empty() && line.text[0] != '#' && line.text[0] != '%') lines.push_back(line);
  }
  return lines;
}

// The separator that cuts most of the first lines into the same number of cells.
char separator_of(const std::vector<Line>& lines) {
  const std::size_t looked = std::min<std::size_t>(lines.size(), 20);
  const Line& last = lines[looked - 1];
  for (const char c : {';', '\t', ','})
    if (std::count(last.text.begin(), last.text.end(), c) > 0) return c;
  return ',';
}

struct Parser {
  csv_parser state{};
  explicit Parser(char separator) {
    csv_init(&state, CSV_APPEND_NULL);
    csv_set_delim(&state, static_cast<unsigned char>(separator));
  }
  ~Parser() { csv_free(&state); }
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;

  Row cells(const std::string& line) {
    Row row;
    const auto cell = [](void* text, std::size_t size, void* to) {
      static_cast<Row*>(to)->emplace_back(trimmed({static_cast<const char*>(text), size}));
    };
    const auto end = [](int, void*) {};
    csv_parse(&state, line.data(), line.size(), cell, end, &row);
    csv_fini(&state, cell, end, &row);
    return row;
  }
};

void name_columns(CsvTable& table, const Row& header) {
  for (const std::string& cell : header) {
    CsvColumn column{.name = cell, .unit = "", .real = {}, .imaginary = {}};
    if (const auto open = cell.rfind('['); open != std::string::npos && cell.back() == ']') {
      column.unit = cell.substr(open + 1, cell.size() - open - 2);
      column.name = trimmed(cell.substr(0, open));
    } else if (const auto round = cell.rfind('(');
               round != std::string::npos && cell.back() == ')') {
      const std::string inside = cell.substr(round + 1, cell.size() - round - 2);
      if (lab_unit(inside)) { // or a part of the name
        column.unit = inside;
        column.name = trimmed(cell.substr(0, round));
      }
    }
    table.columns.push_back(std::move(column));
  }
}

void check_width(const Row& row, std::size_t width, const std::filesystem::path& path, int line) {
  if (row.size() != width)
    bad(path, line, "", "has " + std::to_string(row.size()) + " cells",
        std::to_string(width) + " as in the first row");
}

bool is_numeric(const Row& row, bool decimal_comma) {
  return std::all_of(row.begin(), row.end(), [&](const std::string& cell) {
    return complex_of(cell, decimal_comma).has_value();
  });
}

std::string text_of(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path))
    bad(path, 0, "", "is no file", "the path of a CSV file");
  return in_utf8(read_whole(path));
}

} // namespace

CsvTable read_csv(const std::filesystem::path& path) {
  return csv_of_text(text_of(path), path);
}

CsvCells read_cells(const std::filesystem::path& path) {
  const std::vector<Line> lines = lines_of(text_of(path));
  if (lines.size() < 2) bad(path, 1, "", "has no rows", "a header, and rows below it");
  Parser parser(separator_of(lines));
  CsvCells cells{.header = parser.cells(lines.front().text), .rows = {}};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    cells.rows.push_back(parser.cells(lines[i].text));
    check_width(cells.rows.back(), cells.header.size(), path, lines[i].number);
  }
  return cells;
}

CsvTable csv_of_text(const std::string& text, const std::filesystem::path& path) {
  const std::vector<Line> lines = lines_of(text);
  if (lines.empty()) bad(path, 1, "", "has no rows", "a table of numbers");
  const char separator = separator_of(lines);
  const bool decimal_comma =
      separator != ',' && std::any_of(lines.begin() + 1, lines.end(), [](const Line& line) {
        return line.text.find(',') != std::string::npos;
      });
  Parser parser(separator);
  std::vector<Row> rows;
  for (const Line& line : lines) rows.push_back(parser.cells(line.text));
  std::size_t first = 0;
  CsvTable table;
  table.header = !is_numeric(rows[0], decimal_comma);
  if (table.header) {
    name_columns(table, rows[0]);
    table.header_line = lines[0].number;
    first = 1;
  } else {
    table.columns.resize(rows[0].size());
  }
  const std::size_t count = rows.size() - first, width = table.columns.size();
  if (count == 0) bad(path, lines[0].number, "", "has a header and no rows", "a table of numbers");
  std::vector<bool> is_complex(width, false);
  Eigen::MatrixXcd values{Eigen::Index(count), Eigen::Index(width)};
  for (std::size_t r = 0; r < count; ++r) {
    const Row& row = rows[first + r];
    const int line = lines[first + r].number;
    check_width(row, width, path, line);
    for (std::size_t c = 0; c < width; ++c) {
      const auto value = complex_of(row[c], decimal_comma);
      if (!value || !std::isfinite(value->real()) || !std::isfinite(value->imag()))
        bad(path, line, "column " + std::to_string(c + 1),
            "'" + row[c].substr(0, 40) + "' is no number", "finite numbers, real or like 1.5-0.2j");
      values(Eigen::Index(r), Eigen::Index(c)) = *value;
      is_complex[c] = is_complex[c] || row[c].find_first_of("ij") != std::string::npos;
    }
  }
  for (std::size_t c = 0; c < width; ++c) {
    table.columns[c].real = values.col(Eigen::Index(c)).real();
    if (is_complex[c]) table.columns[c].imaginary = values.col(Eigen::Index(c)).imag();
  }
  return table;
}

} // namespace plica

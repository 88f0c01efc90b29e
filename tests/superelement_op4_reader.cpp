#include "io/files/files.hpp"
#include "tests/superelement_readers.hpp"

#include <sstream>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr int per_line = 3, width = 23; // 1P,3E23.16

// Lines of a file cut into fields of fixed width.
class Fields {
public:
  explicit Fields(const std::filesystem::path& path) : path_(path), stream_(read_whole(path)) {}

  bool next() {
    ++number_;
    return static_cast<bool>(std::getline(stream_, line_));
  }
  [[noreturn]] void bad(const std::string& what) const { bad_line(path_, number_, what); }

  int whole(std::size_t at) const { return static_cast<int>(real(at, 8)); }
  double real(std::size_t at, std::size_t size) const {
    const std::string field = text(at, size);
    try {
      std::size_t used = 0;
      const double value = std::stod(field, &used);
      if (used == field.size()) return value;
    } catch (const std::logic_error&) {
    }
    bad("'" + field + "' is not a number");
  }
  std::string text(std::size_t at, std::size_t size) const {
    if (at >= line_.size()) bad("the line ends early");
    std::string field = line_.substr(at, size);
    field.erase(0, field.find_first_not_of(' '));
    field.erase(field.find_last_not_of(" \r") + 1);
    return field;
  }

private:
  const std::filesystem::path& path_;
  std::istringstream stream_;
  std::string line_;
  int number_ = 0;
};

MatrixXd read_columns(Fields& fields, Index rows, Index columns) {
  MatrixXd A = MatrixXd::Zero(rows, columns);
  while (true) {
    if (!fields.next()) fields.bad("the file ends within a matrix");
    const int column = fields.whole(0), first = fields.whole(8), count = fields.whole(16);
    const bool end = column == columns + 1;
    if (!end &&
        (column < 1 || column > columns || first < 1 || count < 1 || first + count - 1 > rows))
      fields.bad("a column lies outside of its matrix");
    for (int k = 0; k < count; ++k) {
      if (k % per_line == 0 && !fields.next()) fields.bad("the file ends within a column");
      const double value = fields.real(width * std::size_t(k % per_line), width);
      if (!end) A(first - 1 + k, column - 1) = value;
    }
    if (end) return A;
  }
}

} // namespace

std::map<std::string, MatrixXd> read_op4(const std::filesystem::path& path) {
  constexpr int largest = 100000;
  Fields fields(path);
  std::map<std::string, MatrixXd> matrices;
  while (fields.next()) {
    const int columns = fields.whole(0), rows = fields.whole(8);
    if (columns < 1 || rows < 1 || columns > largest || rows > largest)
      fields.bad("is not the header of a dense OUTPUT4 matrix");
    if (fields.whole(24) != 2) fields.bad("the matrix is not of real numbers in double precision");
    const std::string name = fields.text(32, 8);
    matrices[name] = read_columns(fields, rows, columns);
  }
  if (matrices.empty()) fields.bad("there is no matrix");
  return matrices;
}

} // namespace plica

#include "io/superelements/matrix_market.hpp"

#include "io/files/files.hpp"
#include "io/superelements/labels.hpp"

#include <fmt/format.h>

#include <sstream>

namespace plica {

using Eigen::MatrixXd;

std::string matrix_market(const MatrixXd& A, const std::string& comment) {
  std::string entries;
  int count = 0;
  for (int j = 0; j < A.cols(); ++j)
    for (int i = j; i < A.rows(); ++i) {
      if (A(i, j) == 0) continue;
      entries += fmt::format("{} {} {:.17g}\n", i + 1, j + 1, A(i, j));
      ++count;
    }
  return fmt::format("%%MatrixMarket matrix coordinate real symmetric\n% {}\n{} {} {}\n", comment,
                     A.rows(), A.cols(), count) +
         entries;
}

std::string general_matrix_market(const MatrixXd& A, const std::string& comment) {
  std::string entries;
  int count = 0;
  for (int j = 0; j < A.cols(); ++j)
    for (int i = 0; i < A.rows(); ++i) {
      if (A(i, j) == 0) continue;
      entries += fmt::format("{} {} {:.17g}\n", i + 1, j + 1, A(i, j));
      ++count;
    }
  return fmt::format("%%MatrixMarket matrix coordinate real general\n% {}\n{} {} {}\n", comment,
                     A.rows(), A.cols(), count) +
         entries;
}

MatrixXd read_matrix_market(const std::filesystem::path& path) {
  std::istringstream stream(read_whole(path));
  std::string line;
  std::getline(stream, line);
  if (line != "%%MatrixMarket matrix coordinate real symmetric")
    bad_line(path, 1, "is not a symmetric real coordinate matrix of Matrix Market");
  MatrixXd A;
  for (int number = 2; std::getline(stream, line); ++number) {
    if (line.empty() || line[0] == '%') continue;
    std::istringstream fields(line);
    Eigen::Index i = 0, j = 0;
    double value = 0;
    if (!(fields >> i >> j >> value)) bad_line(path, number, "does not hold three numbers");
    if (A.size() == 0) {
      if (i != j || i < 1 || i > 100000)
        bad_line(path, number, "is not the size of a square matrix");
      A = MatrixXd::Zero(i, j);
    } else if (i < 1 || j < 1 || i > A.rows() || j > A.cols()) {
      bad_line(path, number, "lies outside of the matrix");
    } else {
      A(i - 1, j - 1) = A(j - 1, i - 1) = value;
    }
  }
  if (A.size() == 0) bad_line(path, 1, "has no matrix");
  return A;
}

} // namespace plica

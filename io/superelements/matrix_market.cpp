#include "io/superelements/matrix_market.hpp"

#include <fmt/format.h>

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

} // namespace plica

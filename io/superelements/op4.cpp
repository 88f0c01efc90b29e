#include "io/superelements/op4.hpp"

#include "io/superelements/labels.hpp"

#include <fmt/format.h>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr int per_line = 3, width = 23;

std::string op4_name(char letter, const std::string& name) {
  return (letter == 'C' ? "B" : letter == 'D' ? "K4" : std::string(1, letter)) + name;
}

void add_matrix(std::string& text, const std::string& name, const MatrixXd& A, int form = 6) {
  text += fmt::format("{:8}{:8}{:8}{:8}{:<8}1P,{}E{}.16\n", A.cols(), A.rows(), form, 2, name,
                      per_line, width);
  for (Index j = 0; j < A.cols(); ++j) {
    Index first = 0, last = A.rows() - 1;
    while (first <= last && A(first, j) == 0) ++first;
    while (last >= first && A(last, j) == 0) --last;
    if (first > last) continue;
    text += fmt::format("{:8}{:8}{:8}\n", j + 1, first + 1, last - first + 1);
    for (Index i = first; i <= last; ++i) {
      text += fmt::format("{:{}.16E}", A(i, j), width);
      if ((i - first + 1) % per_line == 0 || i == last) text += '\n';
    }
  }
  text += fmt::format("{:8}{:8}{:8}\n{:{}.16E}\n", A.cols() + 1, 1, 1, 1., width);
}

} // namespace

std::string op4_file(const Superelement& s, const ElementLabels& labels) {
  std::string text;
  for (const NamedMatrix& m : matrices_of(s))
    add_matrix(text, op4_name(m.letter, labels.name), *m.matrix);
  if (s.recovery.empty()) return text;
  constexpr int rectangular = 2;
  add_matrix(text, "OTM" + labels.name, recovery_matrix(s), rectangular);
  return text;
}

} // namespace plica

#include "io/superelement_abaqus.hpp"

#include "io/superelement_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace plica {
namespace {

using Eigen::MatrixXd;

int coordinate_of(const Superelement& s, int node, int dof) {
  if (node >= first_scalar) return s.boundary() + node - first_scalar;
  return 6 * (node - first_grid) + dof - 1;
}

} // namespace

std::string abaqus_deck(const Superelement& s, const std::string& stiffness_file,
                        const std::string& mass_file) {
  std::string deck =
      fmt::format("** Superelement {}: SI units (m, kg, s, N, rad)\n"
                  "** nodes {}..: boundary, DOFs 1-6; nodes {}..: modal coordinates, "
                  "DOF 1\n*NODE, NSET=PLICA_BOUNDARY\n",
                  s.name, first_grid, first_scalar);
  for (std::size_t k = 0; k < s.nodes.size(); ++k)
    deck += fmt::format("{}, {:.17g}, {:.17g}, {:.17g}\n** {}\n", first_grid + k, s.nodes[k][0],
                        s.nodes[k][1], s.nodes[k][2], s.node_names[k]);
  if (s.modal() > 0) deck += "*NODE, NSET=PLICA_MODAL\n";
  for (int j = 0; j < s.modal(); ++j) deck += fmt::format("{}, 0., 0., 0.\n", first_scalar + j);
  deck +=
      fmt::format("*MATRIX INPUT, NAME=PLICA_K, INPUT={}\n*MATRIX INPUT, NAME=PLICA_M, INPUT={}\n"
                  "*MATRIX ASSEMBLE, STIFFNESS=PLICA_K, MASS=PLICA_M\n",
                  stiffness_file, mass_file);
  return deck;
}

std::string abaqus_matrix(const Superelement& s, const MatrixXd& A) {
  std::string text;
  for (int j = 0; j < A.cols(); ++j)
    for (int i = j; i < A.rows(); ++i) {
      if (A(i, j) == 0) continue;
      const CoordinateLabel row = coordinate_label(s, i), column = coordinate_label(s, j);
      text += fmt::format("{}, {}, {}, {}, {:.17g}\n", row.point, std::max(1, row.dof),
                          column.point, std::max(1, column.dof), A(i, j));
    }
  return text;
}

MatrixXd read_abaqus_matrix(const Superelement& s, const std::filesystem::path& path) {
  std::istringstream stream(read_whole(path));
  MatrixXd A = MatrixXd::Zero(s.K.rows(), s.K.rows());
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (line.empty() || line.starts_with("**")) continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    int node1 = 0, dof1 = 0, node2 = 0, dof2 = 0;
    double value = 0;
    std::string more;
    if (!(fields >> node1 >> dof1 >> node2 >> dof2 >> value) || fields >> more)
      bad_line(path, number, "is not \"node, DOF, node, DOF, value\"");
    const int i = coordinate_of(s, node1, dof1), j = coordinate_of(s, node2, dof2);
    if (std::min(i, j) < 0 || std::max(i, j) >= A.rows())
      bad_line(path, number, "names a node that the superelement has not");
    A(i, j) = A(j, i) = value;
  }
  return A;
}

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

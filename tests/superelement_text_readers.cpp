#include "tests/superelement_readers.hpp"

#include "io/decks/nastran_cards.hpp"
#include "io/files/files.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::MatrixXd;

// Tells a whole deck from one that was cut off.
constexpr const char* last_line_of_deck = "$ End of the superelement";

int coordinate_of(const Superelement& s, int node, int dof, const ElementLabels& labels) {
  const int mode = node - labels.first_mode, own = node - labels.first_node;
  if (mode >= 0 && mode < s.modal()) return s.boundary() + mode;
  return own >= 0 && own < int(s.nodes.size()) && dof >= 1 && dof <= 6 ? 6 * own + dof - 1 : -1;
}

} // namespace

void bad_line(const std::filesystem::path& path, int line, const std::string& what) {
  throw std::runtime_error(path.string() + ":" + std::to_string(line) + ": " + what);
}

Superelement read_nastran_deck(const std::filesystem::path& path) {
  std::istringstream stream(read_whole(path));
  Superelement s;
  std::map<int, int> coordinate; // of the first DOF of a point
  std::string line, matrix;
  int number = 0, column = -1, size = 0;
  Eigen::Vector3d place;
  bool grid_open = false, whole = false, in_system = false;
  int last_grid = 0;
  const auto cut = [&](std::size_t at, std::size_t width) {
    return line.size() > at ? line.substr(at, width) : std::string();
  };
  const auto matrix_of = [&](const std::string& name) -> MatrixXd& {
    if (name.starts_with("K4")) return s.D;
    return name[0] == 'K' ? s.K : name[0] == 'M' ? s.M : s.C;
  };
  const auto at_label = [&](const std::string& point, const std::string& dof) {
    const auto found = coordinate.find(std::stoi(point));
    if (found == coordinate.end())
      bad_line(path, number, "there is no point " + std::to_string(std::stoi(point)));
    return found->second + std::max(0, std::stoi(dof) - 1);
  };
  while (std::getline(stream, line)) {
    ++number;
    if (line == last_line_of_deck) whole = true;
    if (const auto at = line.find(", units: ");
        line.starts_with("$ Superelement ") && at != line.npos)
      s.units = line.substr(at + 9);
    if (line.empty() || line[0] == '$') continue;
    try {
      const std::string card = cut(0, 8);
      if (card.starts_with("CORD2R") || (in_system && card.starts_with("*"))) {
        in_system = true;
      } else if (card.starts_with("GRID*")) {
        last_grid = std::stoi(cut(8, 16));
        coordinate[last_grid] = size;
        size += 6;
        in_system = false;
        place.x() = nastran_number(cut(40, 16));
        place.y() = nastran_number(cut(56, 16));
        grid_open = true;
      } else if (card.starts_with("*") && grid_open) {
        place.z() = nastran_number(cut(8, 16));
        s.nodes.push_back(place);
        s.node_names.push_back("grid " + std::to_string(last_grid));
        grid_open = false;
      } else if (card.starts_with("SPOINT")) {
        coordinate[std::stoi(cut(8, 8))] = size++;
      } else if (card.starts_with("DMIG*")) {
        if (s.K.size() == 0) s.K = s.M = MatrixXd::Zero(size, size);
        matrix = cut(8, 16);
        MatrixXd& A = matrix_of(matrix);
        if (A.size() == 0) A = MatrixXd::Zero(size, size);
        column = at_label(cut(24, 16), cut(40, 16));
      } else if (card.starts_with("*") && column >= 0) {
        MatrixXd& A = matrix_of(matrix);
        const int row = at_label(cut(8, 16), cut(24, 16));
        const double value = nastran_number(cut(40, 16));
        A(row, column) += value;
        if (row != column) A(column, row) += value;
      } else if (!card.starts_with("DMIG")) {
        bad_line(path, number, "unknown card '" + card + "'");
      }
    } catch (const std::logic_error&) { // std::stoi, std::stod
      bad_line(path, number, "a field is not a number");
    }
  }
  if (!whole)
    bad_line(path, number,
             std::string("the deck is cut off: its last line should be '") + last_line_of_deck +
                 "'");
  if (s.K.isZero(0) && s.modal() > 0) bad_line(path, number, "there is no DMIG matrix KPLICA");
  if (s.M.size() == 0 || s.M.isZero(0)) bad_line(path, number, "there is no DMIG matrix MPLICA");
  return s;
}

std::pair<MatrixXd, MatrixXd> read_abaqus_user_element(const Superelement& s,
                                                       const std::filesystem::path& path) {
  std::istringstream stream(read_whole(path));
  const Eigen::Index n = s.K.rows();
  MatrixXd K(n, n), M(n, n);
  MatrixXd* matrix = nullptr;
  Eigen::Index i = 0, j = 0;
  int matrices = 0, number = 1;
  std::string line;
  for (; std::getline(stream, line); ++number) {
    if (line.starts_with("*")) {
      if (matrix && j != n) bad_line(path, number, "the matrix before is too short");
      matrix = nullptr;
      if (line.starts_with("*MATRIX, TYPE=")) {
        matrix = line.ends_with("STIFFNESS") ? &K : &M;
        i = j = 0;
        ++matrices;
      }
      continue;
    }
    if (!matrix) continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    double value = 0;
    while (fields >> value) {
      if (j == n) bad_line(path, number, "the matrix is too long");
      (*matrix)(i, j) = (*matrix)(j, i) = value;
      if (i++ == j) {
        i = 0;
        ++j;
      }
    }
    if (!fields.eof()) bad_line(path, number, "holds something that is not a number");
  }
  if (matrices != 2) bad_line(path, number, "has not a stiffness and a mass matrix");
  return {K, M};
}

MatrixXd read_abaqus_matrix(const Superelement& s, const std::filesystem::path& path,
                            const ElementLabels& labels) {
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
    const int i = coordinate_of(s, node1, dof1, labels), j = coordinate_of(s, node2, dof2, labels);
    if (std::min(i, j) < 0 || std::max(i, j) >= A.rows())
      bad_line(path, number, "names a node that the superelement has not");
    A(i, j) = A(j, i) = value;
  }
  return A;
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

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

// Cards of the deck one after another: grid points and scalar points, then matrices over them.
class DmigDeck {
public:
  explicit DmigDeck(const std::filesystem::path& path) : path_(path) {}

  Superelement read() {
    std::istringstream stream(read_whole(path_));
    bool whole = false;
    while (std::getline(stream, line_)) {
      ++number_;
      if (line_ == last_line_of_deck) whole = true;
      take_units();
      if (line_.empty() || line_[0] == '$') continue;
      try {
        take_card(cut(0, 8));
      } catch (const std::logic_error&) { // std::stoi, std::stod
        bad("a field is not a number");
      }
    }
    if (!whole)
      bad(std::string("the deck is cut off: its last line should be '") + last_line_of_deck + "'");
    if (s_.K.isZero(0) && s_.modal() > 0) bad("there is no DMIG matrix KPLICA");
    if (s_.M.size() == 0 || s_.M.isZero(0)) bad("there is no DMIG matrix MPLICA");
    return std::move(s_);
  }

private:
  [[noreturn]] void bad(const std::string& what) const { bad_line(path_, number_, what); }

  std::string cut(std::size_t at, std::size_t width) const {
    return line_.size() > at ? line_.substr(at, width) : std::string();
  }

  void take_units() {
    if (const auto at = line_.find(", units: ");
        line_.starts_with("$ Superelement ") && at != line_.npos)
      s_.units = line_.substr(at + 9);
  }

  void take_card(const std::string& card) {
    if (card.starts_with("CORD2R") || (in_system_ && card.starts_with("*"))) {
      in_system_ = true;
    } else if (card.starts_with("GRID*")) {
      open_grid();
    } else if (card.starts_with("*") && grid_open_) {
      close_grid();
    } else if (card.starts_with("SPOINT")) {
      coordinate_[std::stoi(cut(8, 8))] = size_++;
    } else if (card.starts_with("DMIG*")) {
      open_column();
    } else if (card.starts_with("*") && column_ >= 0) {
      take_number();
    } else if (!card.starts_with("DMIG")) {
      bad("unknown card '" + card + "'");
    }
  }

  void open_grid() {
    last_grid_ = std::stoi(cut(8, 16));
    coordinate_[last_grid_] = size_;
    size_ += 6;
    in_system_ = false;
    place_.x() = nastran_number(cut(40, 16));
    place_.y() = nastran_number(cut(56, 16));
    grid_open_ = true;
  }

  void close_grid() {
    place_.z() = nastran_number(cut(8, 16));
    s_.nodes.push_back(place_);
    s_.node_names.push_back("grid " + std::to_string(last_grid_));
    grid_open_ = false;
  }

  void open_column() {
    if (s_.K.size() == 0) s_.K = s_.M = MatrixXd::Zero(size_, size_);
    matrix_ = cut(8, 16);
    MatrixXd& A = matrix();
    if (A.size() == 0) A = MatrixXd::Zero(size_, size_);
    column_ = at_label(cut(24, 16), cut(40, 16));
  }

  void take_number() {
    MatrixXd& A = matrix();
    const int row = at_label(cut(8, 16), cut(24, 16));
    const double value = nastran_number(cut(40, 16));
    A(row, column_) += value;
    if (row != column_) A(column_, row) += value;
  }

  MatrixXd& matrix() {
    if (matrix_.starts_with("K4")) return s_.D;
    return matrix_[0] == 'K' ? s_.K : matrix_[0] == 'M' ? s_.M : s_.C;
  }

  int at_label(const std::string& point, const std::string& dof) const {
    const auto found = coordinate_.find(std::stoi(point));
    if (found == coordinate_.end()) bad("there is no point " + std::to_string(std::stoi(point)));
    return found->second + std::max(0, std::stoi(dof) - 1);
  }

  const std::filesystem::path& path_;
  Superelement s_;
  std::map<int, int> coordinate_; // of the first DOF of a point
  std::string line_, matrix_;
  int number_ = 0, column_ = -1, size_ = 0, last_grid_ = 0;
  Eigen::Vector3d place_;
  bool grid_open_ = false, in_system_ = false;
};

} // namespace

void bad_line(const std::filesystem::path& path, int line, const std::string& what) {
  throw std::runtime_error(path.string() + ":" + std::to_string(line) + ": " + what);
}

Superelement read_nastran_deck(const std::filesystem::path& path) {
  return DmigDeck(path).read();
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

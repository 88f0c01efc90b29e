#include "io/superelements/nastran.hpp"

#include "io/decks/nastran_cards.hpp"
#include "io/files/files.hpp"
#include "io/superelements/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace plica {
namespace {

using Eigen::MatrixXd;

void add_matrix(std::string& deck, const std::string& name, const Superelement& s,
                const MatrixXd& A) {
  deck += fmt::format("DMIG    {:<8}{:>8}{:>8}{:>8}{:>8}\n", name, 0, 6, 2, 0);
  for (int j = 0; j < A.cols(); ++j) {
    const CoordinateLabel column = coordinate_label(s, j);
    std::string rows;
    for (int i = j; i < A.rows(); ++i) {
      if (A(i, j) == 0) continue;
      const CoordinateLabel row = coordinate_label(s, i);
      rows +=
          fmt::format("{:<8}{:>16}{:>16}{:>16}\n", "*", row.point, row.dof, nastran_real(A(i, j)));
    }
    if (!rows.empty())
      deck +=
          fmt::format("{:<8}{:<16}{:>16}{:>16}\n", "DMIG*", name, column.point, column.dof) + rows;
  }
}

// Tells a whole deck from one that was cut off.
constexpr const char* last_line = "$ End of the superelement";

// What is left of A when it stands in the 12 digits of a field.
MatrixXd rest(const MatrixXd& A) {
  return A.unaryExpr([](double x) { return x == 0 ? 0 : x - nastran_number(nastran_real(x)); });
}

} // namespace

std::string nastran_deck(const Superelement& s) {
  std::string deck = fmt::format(
      "$ Superelement {}, units: {}\n"
      "$ Case control: K2GG = KPLICA, KPLICAL and M2GG = MPLICA, MPLICAL{}{}\n"
      "$ GRID: boundary nodes, SPOINT: modal coordinates\n",
      s.name, s.units, s.C.size() > 0 ? "\n$ Viscous damping: B2GG = BPLICA, BPLICAL" : "",
      s.D.size() > 0 ? "\n$ Structural damping: K42GG = K4PLICA, K4PLICL" : "");
  for (std::size_t k = 0; k < s.nodes.size(); ++k) {
    const Eigen::Vector3d& x = s.nodes[k];
    deck += fmt::format("$ {}\n{:<8}{:>16}{:>16}{:>16}{:>16}\n{:<8}{:>16}\n", s.node_names[k],
                        "GRID*", first_grid + k, "", nastran_real(x[0]), nastran_real(x[1]), "*",
                        nastran_real(x[2]));
  }
  for (int j = 0; j < s.modal(); ++j) deck += fmt::format("SPOINT  {:>8}\n", first_scalar + j);
  add_matrix(deck, "KPLICA", s, s.K);
  add_matrix(deck, "KPLICAL", s, rest(s.K));
  add_matrix(deck, "MPLICA", s, s.M);
  add_matrix(deck, "MPLICAL", s, rest(s.M));
  if (s.C.size() > 0) {
    add_matrix(deck, "BPLICA", s, s.C);
    add_matrix(deck, "BPLICAL", s, rest(s.C));
  }
  if (s.D.size() > 0) {
    add_matrix(deck, "K4PLICA", s, s.D);
    add_matrix(deck, "K4PLICL", s, rest(s.D));
  }
  return deck + last_line + "\n";
}

Superelement read_nastran_deck(const std::filesystem::path& path) {
  std::istringstream stream(read_whole(path));
  Superelement s;
  std::map<int, int> coordinate; // of the first DOF of a point
  std::string line, matrix;
  int number = 0, column = -1, size = 0;
  Eigen::Vector3d place;
  bool grid_open = false, whole = false;
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
    if (line == last_line) whole = true;
    if (const auto at = line.find(", units: ");
        line.starts_with("$ Superelement ") && at != line.npos)
      s.units = line.substr(at + 9);
    if (line.empty() || line[0] == '$') continue;
    try {
      const std::string card = cut(0, 8);
      if (card.starts_with("GRID*")) {
        coordinate[std::stoi(cut(8, 16))] = size;
        size += 6;
        place.x() = nastran_number(cut(40, 16));
        place.y() = nastran_number(cut(56, 16));
        grid_open = true;
      } else if (card.starts_with("*") && grid_open) {
        place.z() = nastran_number(cut(8, 16));
        s.nodes.push_back(place);
        s.node_names.push_back("grid " + std::to_string(first_grid + int(s.nodes.size()) - 1));
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
             std::string("the deck is cut off: its last line should be '") + last_line + "'");
  if (s.K.isZero(0) && s.modal() > 0) bad_line(path, number, "there is no DMIG matrix KPLICA");
  if (s.M.size() == 0 || s.M.isZero(0)) bad_line(path, number, "there is no DMIG matrix MPLICA");
  return s;
}

} // namespace plica

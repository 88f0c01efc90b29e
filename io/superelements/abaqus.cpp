#include "io/superelements/abaqus.hpp"

#include "io/superelements/labels.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plica {
namespace {

using Eigen::MatrixXd;

std::string numbers(const Eigen::Vector3d& x) {
  return fmt::format("{:.17g}, {:.17g}, {:.17g}", x[0], x[1], x[2]);
}

// Nodes in a system of their own, and DOFs along its axes.
std::string in_system(const ElementLabels& l, const std::string& set, const std::string& nodes) {
  if (l.system == 0) return nodes;
  const Eigen::Vector3d x = l.axes.col(0), y = l.axes.col(1);
  return "*SYSTEM\n" + numbers(l.origin) + ", " + numbers(l.origin + x) + "\n" +
         numbers(l.origin + y) + "\n" + nodes + "*SYSTEM\n*TRANSFORM, NSET=" + set + ", TYPE=R\n" +
         numbers(x) + ", " + numbers(y) + "\n";
}

std::string abaqus_nodes(const Superelement& s, const ElementLabels& l) {
  std::string deck =
      fmt::format("** Superelement {}, units: {}\n"
                  "** nodes {}..: boundary, DOFs 1-6; nodes {}..: modal coordinates, "
                  "DOF 1\n",
                  s.name, s.units, l.first_node, l.first_mode);
  std::string nodes = fmt::format("*NODE, NSET={}_BOUNDARY\n", l.name);
  for (std::size_t k = 0; k < s.nodes.size(); ++k)
    nodes += fmt::format("{}, {}\n** {}\n", std::size_t(l.first_node) + k, numbers(s.nodes[k]),
                         s.node_names[k]);
  deck += in_system(l, l.name + "_BOUNDARY", nodes);
  if (s.modal() > 0) deck += fmt::format("*NODE, NSET={}_MODAL\n", l.name);
  for (int j = 0; j < s.modal(); ++j) deck += fmt::format("{}, 0., 0., 0.\n", l.first_mode + j);
  return deck;
}

void add_upper_triangle(std::string& deck, const char* type, const MatrixXd& A) {
  constexpr int per_line = 4;
  deck += fmt::format("*MATRIX, TYPE={}\n", type);
  int count = 0;
  for (Eigen::Index j = 0; j < A.cols(); ++j)
    for (Eigen::Index i = 0; i <= j; ++i)
      deck += fmt::format("{:.17g}{}", A(i, j), ++count % per_line == 0 ? "\n" : ", ");
  if (count % per_line != 0) deck.replace(deck.size() - 2, 2, "\n");
}

} // namespace

std::string abaqus_deck(const Superelement& s, const ElementLabels& l) {
  std::string deck = abaqus_nodes(s, l), assemble = "*MATRIX ASSEMBLE";
  for (const NamedMatrix& m : matrices_of(s)) {
    deck += fmt::format("*MATRIX INPUT, NAME={}_{}, INPUT={}\n", l.name, m.letter,
                        abaqus_matrix_file(m.letter));
    assemble += fmt::format(", {}={}_{}",
                            m.letter == 'K'   ? "STIFFNESS"
                            : m.letter == 'M' ? "MASS"
                            : m.letter == 'C' ? "VISCOUS DAMPING"
                                              : "STRUCTURAL DAMPING",
                            l.name, m.letter);
  }
  return deck + assemble + "\n";
}

std::string abaqus_matrix_file(char letter) {
  return fmt::format("superelement_{}.inp", static_cast<char>(letter - 'A' + 'a'));
}

std::string abaqus_user_element(const Superelement& s, const ElementLabels& l) {
  std::string deck = abaqus_nodes(s, l);
  deck += fmt::format("*USER ELEMENT, LINEAR, NODES={}, TYPE=U1\n1, 2, 3, 4, 5, 6\n",
                      s.nodes.size() + std::size_t(s.modal()));
  if (s.modal() > 0) deck += fmt::format("{}, 1\n", s.nodes.size() + 1); // DOFs from that node on
  add_upper_triangle(deck, "STIFFNESS", s.K);
  add_upper_triangle(deck, "MASS", s.M);
  deck += fmt::format("*ELEMENT, TYPE=U1, ELSET={}\n{}", l.name, l.element);
  int on_line = 1;
  const auto add_node = [&](int node) { // sixteen numbers a line
    deck += fmt::format(",{}{}", on_line++ % 16 == 0 ? "\n" : " ", node);
  };
  for (std::size_t k = 0; k < s.nodes.size(); ++k) add_node(l.first_node + static_cast<int>(k));
  for (int j = 0; j < s.modal(); ++j) add_node(l.first_mode + j);
  return deck + fmt::format("\n*UEL PROPERTY, ELSET={}\n", l.name);
}

std::string abaqus_matrix(const Superelement& s, const MatrixXd& A, const ElementLabels& l) {
  std::string text;
  for (int j = 0; j < A.cols(); ++j)
    for (int i = j; i < A.rows(); ++i) {
      if (A(i, j) == 0) continue;
      const CoordinateLabel row = coordinate_label(s, i, l), column = coordinate_label(s, j, l);
      text += fmt::format("{}, {}, {}, {}, {:.17g}\n", row.point, std::max(1, row.dof),
                          column.point, std::max(1, column.dof), A(i, j));
    }
  return text;
}

// Every DOF of a recovered point follows the coordinates.
std::string abaqus_recovery(const Superelement& s, const ElementLabels& l) {
  constexpr int per_line = 4;
  std::string nodes = fmt::format("*NODE, NSET={}_POINTS\n", l.name), equations;
  for (std::size_t k = 0; k < s.recovery.size(); ++k) {
    const RecoveryRows& r = s.recovery[k];
    const int point = l.first_point + int(k);
    nodes += fmt::format("{}, {}\n** {}\n", point, numbers(r.place), r.name);
    for (int d = 0; d < 6; ++d) {
      std::string terms;
      int count = 1;
      for (int j = 0; j < r.rows.cols(); ++j) {
        if (r.rows(d, j) == 0) continue;
        const CoordinateLabel c = coordinate_label(s, j, l);
        terms += fmt::format(",{}{}, {}, {:.12e}", count % per_line == 0 ? "\n" : " ", c.point,
                             std::max(1, c.dof), r.rows(d, j));
        ++count;
      }
      if (count > 1)
        equations += fmt::format("*EQUATION\n{}\n{}, {}, -1.{}\n", count, point, d + 1, terms);
    }
  }
  return fmt::format("** Inner points of superelement {}, units: {}: they follow its coordinates\n",
                     s.name, s.units) +
         in_system(l, l.name + "_POINTS", nodes) + equations;
}

} // namespace plica

#include "io/superelements/nastran_dmig.hpp"

#include "io/decks/nastran_cards.hpp"
#include "io/superelements/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace plica {
namespace {

using Eigen::MatrixXd;

// Of double precision, in a field of sixteen: 1.234567890D+3.
std::string double_real(double x) {
  std::string text = "0.D+0";
  for (int digits = 14; x != 0 && digits > 0; --digits) {
    const std::string full = fmt::format("{:.{}e}", x, digits);
    const std::size_t e = full.find('e');
    text = fmt::format("{}D{:+d}", full.substr(0, e), std::stoi(full.substr(e + 1)));
    if (text.size() <= 16) break;
  }
  return text;
}

std::string row(const CoordinateLabel& at, double x) {
  return fmt::format("{:<8}{:>16}{:>16}{:>16}\n", "*", at.point, at.dof, double_real(x));
}

std::string column(const std::string& name, const CoordinateLabel& at) {
  return fmt::format("{:<8}{:<16}{:>16}{:>16}\n", "DMIG*", name, at.point, at.dof);
}

void add_matrix(std::string& deck, const std::string& name, const Superelement& s,
                const MatrixXd& A, const ElementLabels& l) {
  deck += fmt::format("DMIG    {:<8}{:>8}{:>8}{:>8}{:>8}\n", name, 0, 6, 2, 0);
  for (int j = 0; j < A.cols(); ++j) {
    std::string rows;
    for (int i = j; i < A.rows(); ++i)
      if (A(i, j) != 0) rows += row(coordinate_label(s, i, l), A(i, j));
    if (!rows.empty()) deck += column(name, coordinate_label(s, j, l)) + rows;
  }
}

// Columns by their numbers.
void add_rectangular(std::string& deck, const std::string& name, const Superelement& s,
                     const MatrixXd& A, const ElementLabels& l) {
  deck += fmt::format("DMIG    {:<8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}\n", name, 0, 9, 2, 0, "",
                      "", A.cols());
  for (int j = 0; j < A.cols(); ++j) {
    std::string rows;
    for (int i = 0; i < A.rows(); ++i)
      if (A(i, j) != 0) rows += row(coordinate_label(s, i, l), A(i, j));
    if (!rows.empty()) deck += column(name, {j + 1, 0}) + rows;
  }
}

// Tells a whole deck from one that was cut off.
constexpr const char* last_line = "$ End of the superelement";

// What is left of A when it stands in the digits of a field.
MatrixXd rest(const MatrixXd& A) {
  return A.unaryExpr([](double x) { return x == 0 ? 0 : x - nastran_number(double_real(x)); });
}

// The axes of the system, where there is one: on z, and in the plane of x and z.
std::string cord2r(const ElementLabels& l) {
  if (l.system == 0) return "";
  std::vector<std::string> fields{std::to_string(l.system), "0"};
  for (const Eigen::Vector3d& x : {l.origin, Eigen::Vector3d(l.origin + l.axes.col(2)),
                                   Eigen::Vector3d(l.origin + l.axes.col(0))})
    for (int i = 0; i < 3; ++i) fields.push_back(nastran_real(x[i]));
  return large_card("CORD2R", fields);
}

std::string grid(int number, const Eigen::Vector3d& x, const ElementLabels& l) {
  const std::string system = l.system == 0 ? "" : std::to_string(l.system);
  return fmt::format("{:<8}{:>16}{:>16}{:>16}{:>16}\n{:<8}{:>16}{}\n", "GRID*", number, system,
                     nastran_real(x[0]), nastran_real(x[1]), "*", nastran_real(x[2]),
                     system.empty() ? "" : fmt::format("{:>16}", system));
}

// K, M, B, K4 with the name behind, and of what the first rounds away.
struct MatrixNames {
  std::string first, rest;
};
MatrixNames names_of(const std::string& letters, const ElementLabels& l) {
  return {letters + l.name, (letters + l.name).substr(0, 7) + "L"};
}

} // namespace

std::string nastran_deck(const Superelement& s, const ElementLabels& l) {
  const std::array<std::pair<std::string, const MatrixXd*>, 4> matrices{
      {{"K", &s.K}, {"M", &s.M}, {"B", &s.C}, {"K4", &s.D}}};
  const auto both = [&](std::size_t k) {
    const MatrixNames n = names_of(matrices[k].first, l);
    return n.first + ", " + n.rest;
  };
  std::string deck =
      fmt::format("$ Superelement {}, units: {}\n"
                  "$ Case control: K2GG = {} and M2GG = {}{}{}\n"
                  "$ GRID: boundary nodes, SPOINT: modal coordinates\n",
                  s.name, s.units, both(0), both(1),
                  s.C.size() > 0 ? "\n$ Viscous damping: B2GG = " + both(2) : "",
                  s.D.size() > 0 ? "\n$ Structural damping: K42GG = " + both(3) : "");
  deck += cord2r(l);
  for (std::size_t k = 0; k < s.nodes.size(); ++k)
    deck += "$ " + s.node_names[k] + "\n" + grid(l.first_node + int(k), s.nodes[k], l);
  for (int j = 0; j < s.modal(); ++j) deck += fmt::format("SPOINT  {:>8}\n", l.first_mode + j);
  for (const auto& [letters, matrix] : matrices) {
    if (matrix->size() == 0) continue;
    const MatrixNames n = names_of(letters, l);
    add_matrix(deck, n.first, s, *matrix, l);
    add_matrix(deck, n.rest, s, rest(*matrix), l);
  }
  return deck + last_line + "\n";
}

std::string nastran_recovery(const Superelement& s, const ElementLabels& l) {
  std::string deck = fmt::format("$ Inner points of superelement {}, units: {}: they follow its "
                                 "coordinates\n$ Case control: MPC = {}\n",
                                 s.name, s.units, l.element);
  for (std::size_t k = 0; k < s.recovery.size(); ++k) {
    const RecoveryRows& r = s.recovery[k];
    const int point = l.first_point + int(k);
    deck += "$ " + r.name + "\n" + grid(point, r.place, l);
    for (int d = 0; d < 6; ++d) {
      std::vector<std::string> fields{std::to_string(l.element), std::to_string(point),
                                      std::to_string(d + 1), "-1."};
      int terms = 1;
      for (int j = 0; j < r.rows.cols(); ++j) {
        if (r.rows(d, j) == 0) continue;
        const CoordinateLabel c = coordinate_label(s, j, l);
        if (++terms > 2 && terms % 2 == 1) fields.insert(fields.end(), {"", ""}); // a new line
        for (const std::string& field :
             {std::to_string(c.point), std::to_string(c.dof), nastran_real(r.rows(d, j))})
          fields.push_back(field);
      }
      if (terms > 1) deck += large_card("MPC", fields);
    }
  }
  return deck;
}

std::string nastran_recovery_matrix(const Superelement& s, const ElementLabels& l) {
  const MatrixNames names = names_of("OTM", l);
  const MatrixXd rows = recovery_matrix(s).transpose();
  std::string deck =
      fmt::format("$ Inner points of superelement {} by its coordinates, units: {}\n"
                  "$ Motion of the points = transpose of {} + {} times that of the coordinates\n",
                  s.name, s.units, names.first, names.rest);
  for (std::size_t k = 0; k < s.recovery.size(); ++k)
    deck += fmt::format("$ Columns {} to {}: {}, ux uy uz rx ry rz\n", 6 * k + 1, 6 * k + 6,
                        s.recovery[k].name);
  add_rectangular(deck, names.first, s, rows, l);
  add_rectangular(deck, names.rest, s, rest(rows), l);
  return deck;
}

} // namespace plica

#include "io/superelements/connector_tables.hpp"

#include "io/decks/nastran_cards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Matrix66c = Eigen::Matrix<std::complex<double>, 6, 6>;
using std::numbers::pi;

struct Property {
  std::string title; // of state and level
  // Per direction, where the harmonic balance found a motion: Hz, k', k'' / w (none at 0 Hz).
  std::array<std::vector<std::array<double, 3>>, 6> rows;
};

std::string level_title(const MotionLevel& level) {
  if (level.translation == 0 && level.rotation == 0) return "small motion";
  return fmt::format("amplitude {:g} m, {:g} rad", level.translation, level.rotation);
}

std::vector<Property> properties_of(const EndDynamicStiffness& s, bool millimetres) {
  std::vector<Property> list;
  for (const StateStiffness& state : s.states)
    for (std::size_t l = 0; l < state.over.levels.size(); ++l) {
      Property p{state.name + ", " + level_title(state.over.levels[l]), {}};
      for (Eigen::Index f = 0; f < state.over.hertz.size(); ++f) {
        const Matrix66c k = connector_in_middle(state.over.at[l][std::size_t(f)],
                                                state.part.places[0], state.part.places[1]);
        const double hertz = state.over.hertz[f];
        for (int d = 0; d < 6; ++d) {
          const double unit = millimetres ? (d < 3 ? 1e-3 : 1e3) : 1; // N/mm, N mm/rad
          if (std::isfinite(std::abs(k(d, d))))
            p.rows[std::size_t(d)].push_back(
                {hertz, unit * k(d, d).real(),
                 hertz > 0 ? unit * k(d, d).imag() / (2 * pi * hertz) : 0});
        }
      }
      list.push_back(std::move(p));
    }
  return list;
}

std::array<Eigen::Vector3d, 3> places_of(const EndDynamicStiffness& s, bool millimetres) {
  const auto& at = s.states.front().part.places;
  const double unit = millimetres ? 1e3 : 1;
  return {unit * at[0], unit * at[1], unit * (at[0] + at[1]) / 2};
}

// What every file says of itself.
std::vector<std::string> head(const EndDynamicStiffness& s, bool millimetres) {
  std::vector<std::string> lines{
      fmt::format("Dynamic stiffness of {} from {} to {} over frequency, units: {}", s.case_name,
                  s.states.front().part.names[0], s.states.front().part.names[1],
                  millimetres ? "mm t s N rad" : "m kg s N rad"),
      "Blocked transfer stiffness as springs and dashpots in the middle between the ends; the mass",
      "of the part is not in it, nor what couples directions there:"};
  for (const StateStiffness& state : s.states)
    lines.push_back(fmt::format("  {}: up to {:.2g} of the root of both terms", state.name,
                                left_off_diagonal(state)));
  return lines;
}

} // namespace

double left_off_diagonal(const StateStiffness& state) {
  double largest = 0;
  for (const auto& level : state.over.at)
    for (const Complex1212& Z : level) {
      const Matrix66c k = connector_in_middle(Z, state.part.places[0], state.part.places[1]);
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
          if (const double share = std::abs(k(i, j)) / std::sqrt(std::abs(k(i, i) * k(j, j)));
              i != j && std::isfinite(share))
            largest = std::max(largest, share);
    }
  return largest;
}

std::string abaqus_connector(const EndDynamicStiffness& s, bool millimetres) {
  std::string deck;
  for (const std::string& line : head(s, millimetres)) deck += "** " + line + "\n";
  const auto places = places_of(s, millimetres);
  deck += "** nodes 1 and 2 are the ends\n*NODE, NSET=PLICA_ENDS\n";
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector3d& x = places[std::min(k, std::size_t(2))];
    deck += fmt::format("{}{}, {:.13g}, {:.13g}, {:.13g}\n", k == 2 ? "*NODE\n" : "", k + 1, x[0],
                        x[1], x[2]);
  }
  deck += "*MPC\nBEAM, 3, 1\nBEAM, 4, 2\n"
          "*ELEMENT, TYPE=CONN3D2, ELSET=PLICA_PART\n1, 3, 4\n"
          "*CONNECTOR SECTION, ELSET=PLICA_PART, BEHAVIOR=PLICA_1\nCARTESIAN, CARDAN\n";
  int number = 0;
  for (const Property& p : properties_of(s, millimetres)) {
    deck += fmt::format("** {}\n*CONNECTOR BEHAVIOR, NAME=PLICA_{}\n", p.title, ++number);
    for (std::size_t d = 0; d < 6; ++d) {
      if (p.rows[d].empty()) continue;
      deck += fmt::format("*CONNECTOR ELASTICITY, COMPONENT={}\n", d + 1);
      for (const auto& [hertz, k, c] : p.rows[d])
        deck += fmt::format("{:.12e}, {:.12g}\n", k, hertz);
      deck += fmt::format("*CONNECTOR DAMPING, COMPONENT={}\n", d + 1);
      for (const auto& [hertz, k, c] : p.rows[d])
        if (hertz > 0) deck += fmt::format("{:.12e}, {:.12g}\n", c, hertz);
    }
  }
  return deck;
}

std::string nastran_bush(const EndDynamicStiffness& s, bool millimetres) {
  std::string deck;
  for (const std::string& line : head(s, millimetres)) deck += "$ " + line + "\n";
  const auto places = places_of(s, millimetres);
  deck += "$ grids 1 and 2 are the ends\n";
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector3d& x = places[std::min(k, std::size_t(2))];
    deck += large_card("GRID", {std::to_string(k + 1), "", nastran_real(x[0]), nastran_real(x[1]),
                                nastran_real(x[2])});
  }
  deck += small_card("RBE2", {"2", "1", "123456", "3"}) +
          small_card("RBE2", {"3", "2", "123456", "4"}) +
          small_card("CBUSH", {"1", "1", "3", "4", "", "", "", "0"});
  int number = 0, table = 0;
  for (const Property& p : properties_of(s, millimetres)) {
    const std::string id = std::to_string(++number);
    std::string tables;
    std::vector<std::string> nominal{id, "K"}, over{id, "K"}, dampers{"", "B"};
    for (const auto& rows : p.rows) {
      nominal.push_back(rows.empty() ? "" : nastran_real(rows.front()[1]));
      for (const std::size_t what : {std::size_t(1), std::size_t(2)}) {
        std::vector<std::string>& list = what == 1 ? over : dampers;
        std::vector<std::string> fields{std::to_string(++table), "", "", "", "", "", "", ""};
        for (const auto& row : rows)
          if (what == 1 || row[0] > 0)
            for (const double x : {row[0], row[what]}) fields.push_back(nastran_real(x));
        if (fields.size() < 12) { // a table has two points
          list.emplace_back();
          --table;
          continue;
        }
        fields.push_back("ENDT");
        tables += large_card("TABLED1", fields);
        list.push_back(std::to_string(table));
      }
    }
    over.insert(over.end(), dampers.begin(), dampers.end());
    deck +=
        "$ " + p.title + "\n" + large_card("PBUSH", nominal) + small_card("PBUSHT", over) + tables;
  }
  return deck;
}

} // namespace plica

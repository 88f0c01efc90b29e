#include "io/tables/stiffness_words.hpp"

#include "io/tables/csv.hpp"
#include "io/tables/text.hpp"
#include "io/tables/text_table.hpp"
#include "words/directions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace plica {
namespace {

using std::numbers::pi;

constexpr double degree = pi / 180;

std::string unit_of(int row, int column) {
  const bool moment = row % 6 >= 3, turn = column % 6 >= 3;
  return std::string(moment ? "Nm" : "N") + (turn ? "/rad" : "/m");
}

// The cells of state, level and frequency, for every one of them.
template <class F> void for_each_row(const EndDynamicStiffness& s, F&& row) {
  for (const StateStiffness& state : s.states)
    for (std::size_t l = 0; l < state.over.levels.size(); ++l)
      for (Eigen::Index f = 0; f < state.over.hertz.size(); ++f) {
        const MotionLevel& level = state.over.levels[l];
        row(state, l, f,
            fmt::format("{},{},{},{}", csv_cell(state.name), csv_number(level.translation),
                        csv_number(level.rotation), csv_number(state.over.hertz[f])));
      }
}

constexpr const char* row_head = "state,amplitude [m],angle of motion [rad],frequency [Hz]";

std::string three_cells(std::complex<double> k) {
  return fmt::format(",{},{},{}", csv_number(k.real()), csv_number(k.imag()),
                     csv_number(std::arg(k) / degree));
}

double deviation(const StiffnessComparison& c) {
  const bool angle = c.measured.quantity == StiffnessQuantity::loss_angle;
  return angle ? c.computed - c.measured.value : c.computed / c.measured.value - 1;
}

} // namespace

std::string level_name(const MotionLevel& level) {
  std::string text;
  if (level.translation > 0) text = fmt::format("{:g} mm", 1e3 * level.translation);
  if (level.rotation > 0)
    text += fmt::format("{}{:g} deg", text.empty() ? "" : ", ", level.rotation / degree);
  return text.empty() ? "small motion" : text;
}

std::vector<std::array<int, 2>> terms_of(const EndDynamicStiffness& s) {
  constexpr double rounding = 1e-9; // of the root of both driving-point stiffnesses
  std::vector<std::array<int, 2>> terms;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) {
      bool any = false;
      for (const StateStiffness& state : s.states)
        for (const auto& level : state.over.at)
          for (const Complex1212& Z : level)
            any =
                any || std::abs(Z(i, j)) >
                           rounding * std::sqrt(std::abs(state.part.K(i, i) * state.part.K(j, j)));
      if (any) terms.push_back({i, j});
    }
  return terms;
}

std::string stiffness_csv(const EndDynamicStiffness& s) {
  const std::vector<std::array<int, 2>> terms = terms_of(s);
  const std::vector<std::string> names = end_coordinate_names(s.states.front().part.names);
  std::string text = row_head;
  for (const auto& [i, j] : terms) {
    const std::string term = names[std::size_t(i)] + " by " + names[std::size_t(j)];
    for (const char* what : {"storage", "loss"})
      text += "," + csv_cell(fmt::format("{} {} [{}]", term, what, unit_of(i, j)));
    text += "," + csv_cell(term + " loss angle [deg]");
  }
  text += "\n";
  for_each_row(
      s, [&](const StateStiffness& state, std::size_t l, Eigen::Index f, const std::string& head) {
        text += head;
        const Complex1212& Z = state.over.at[l][std::size_t(f)];
        for (const auto& [i, j] : terms) text += three_cells(Z(i, j));
        text += "\n";
      });
  return text;
}

std::string transfer_stiffness_csv(const EndDynamicStiffness& s) {
  std::string text = row_head;
  text += ",direction,unit";
  for (const char* k : {"driving point k11", "driving point k22", "blocked transfer k21"})
    text += fmt::format(",{0} storage,{0} loss,{0} loss angle [deg]", k);
  text += ",level of k21 [dB],loss factor of k21\n";
  for_each_row(
      s, [&](const StateStiffness& state, std::size_t l, Eigen::Index f, const std::string& head) {
        const Complex1212& Z = state.over.at[l][std::size_t(f)];
        for (int d = 0; d < 6; ++d) {
          const std::complex<double> k21 = transfer_stiffness(Z, d);
          text += head + "," + direction_names[std::size_t(d)] + "," + unit_of(d, d) +
                  three_cells(driving_point_stiffness(Z, d, 0)) +
                  three_cells(driving_point_stiffness(Z, d, 1)) + three_cells(k21) +
                  fmt::format(",{},{}\n", csv_number(20 * std::log10(std::abs(k21))),
                              csv_number(k21.imag() / k21.real()));
        }
      });
  return text;
}

std::string stiffness_comparison_csv(const std::vector<StiffnessComparison>& rows) {
  std::string text =
      "frequency [Hz],amplitude [m or rad],quantity,unit,measured,computed,deviation\n";
  for (const StiffnessComparison& c : rows) {
    const bool angle = c.measured.quantity == StiffnessQuantity::loss_angle;
    text +=
        fmt::format("{},{},{},{},{},{},{}\n", csv_number(c.measured.hertz),
                    csv_number(c.measured.amplitude), csv_cell(measured_name(c.measured)),
                    angle ? "rad" : unit_of(c.measured.direction, c.measured.direction),
                    csv_number(c.measured.value), csv_number(c.computed), csv_number(deviation(c)));
  }
  return text;
}

std::vector<ShownDeviation> deviations(const std::vector<StiffnessComparison>& rows) {
  std::vector<ShownDeviation> list;
  for (const StiffnessComparison& c : rows) {
    const std::string name = measured_name(c.measured);
    auto own = std::find_if(list.begin(), list.end(),
                            [&](const ShownDeviation& d) { return d.name == name; });
    const bool angle = c.measured.quantity == StiffnessQuantity::loss_angle;
    if (own == list.end()) own = list.insert(own, {.name = name, .unit = angle ? "deg" : "%"});
    const double d = deviation(c) * (angle ? 1 / degree : 100);
    if (!std::isfinite(d)) continue;
    ++own->count;
    own->mean += d;
    own->root_mean_square += d * d;
    if (std::abs(d) > std::abs(own->largest)) own->largest = d;
  }
  for (ShownDeviation& d : list) {
    d.mean /= std::max(1, d.count);
    d.root_mean_square = std::sqrt(d.root_mean_square / std::max(1, d.count));
  }
  return list;
}

std::string stiffness_text(const EndDynamicStiffness& s,
                           const std::vector<StiffnessComparison>& compared) {
  std::string text;
  for (const StateStiffness& state : s.states) {
    const Eigen::Index last = state.over.hertz.size() - 1;
    std::vector<Eigen::Index> shown{0};
    for (const Eigen::Index f : {last / 2, last})
      if (f > shown.back()) shown.push_back(f);
    text += fmt::format("\nBlocked transfer stiffness from {} to {}, {} ({} modes up to {:.4g} Hz "
                        "and static answers)\n",
                        state.part.names[0], state.part.names[1], state.name, state.modes,
                        s.highest_mode);
    TextRows rows{{"", "Hz"}};
    for (int d = 0; d < 6; ++d) {
      rows[0].push_back(direction_names[std::size_t(d)] + std::string(d < 3 ? " N/mm" : " Nm/rad"));
      rows[0].emplace_back("deg");
    }
    for (std::size_t l = 0; l < state.over.levels.size(); ++l)
      for (const Eigen::Index f : shown) {
        rows.push_back(
            {f == 0 ? level_name(state.over.levels[l]) : "", significant(state.over.hertz[f], 4)});
        for (int d = 0; d < 6; ++d) {
          const auto k = transfer_stiffness(state.over.at[l][std::size_t(f)], d);
          rows.back().push_back(significant(k.real() * (d < 3 ? 1e-3 : 1), 4));
          rows.back().push_back(significant(std::arg(k) / degree, 3));
        }
      }
    text += text_table(rows, "<>");
  }
  if (!compared.empty()) {
    TextRows rows{{"", "unit", "values", "mean", "rms", "largest"}};
    for (const ShownDeviation& d : deviations(compared))
      rows.push_back({d.name, d.unit, std::to_string(d.count), with_sign(d.mean, 2),
                      significant(d.root_mean_square, 3), with_sign(d.largest, 2)});
    text += "\nOff the test\n" + text_table(rows, "<<>");
  }
  for (const std::string& note : s.notes) text += "note: " + note + "\n";
  return text;
}

} // namespace plica

#include "model/description/operating_state.hpp"

#include <algorithm>
#include <stdexcept>

namespace plica {

bool acts(const OperatingState& s) {
  constexpr Triple none{};
  return s.pressure != 0 || s.gravity != none || !s.temperature.empty() || !s.bolt.empty() ||
         std::any_of(s.offset.begin(), s.offset.end(),
                     [&](const EndOffset& o) { return o.move != none || o.turn != none; }) ||
         std::any_of(s.force.begin(), s.force.end(),
                     [&](const EndLoad& l) { return l.force != none || l.moment != none; });
}

double at_temperature(const std::vector<std::array<double, 2>>& table, double temperature) {
  const auto after = std::find_if(table.begin(), table.end(),
                                  [&](const auto& row) { return row[0] >= temperature; });
  if (table.empty() || after == table.end() || temperature < table.front()[0])
    throw std::out_of_range("a temperature beyond its table");
  if (after == table.begin()) return table.front()[1];
  const auto& [t1, v1] = *after;
  const auto& [t0, v0] = *(after - 1);
  return v0 + (v1 - v0) * (temperature - t0) / (t1 - t0);
}

std::array<double, 2> range_of(const PartTemperature& part) {
  std::vector<double> given;
  if (part.at) given.push_back(*part.at);
  for (const auto& row : part.along) given.push_back(row[1]);
  for (const HeldTemperature& h : part.held) given.push_back(h.temperature);
  for (const std::optional<Film>& film : {part.inside, part.outside})
    if (film) given.push_back(film->gas);
  const auto [low, high] = std::minmax_element(given.begin(), given.end());
  return {*low, *high};
}

double temperature_at(const PartTemperature& part, double y) {
  if (part.at) return *part.at;
  return at_temperature(part.along, std::clamp(y, part.along.front()[0], part.along.back()[0]));
}

} // namespace plica

#include "model/description/operating_state.hpp"

#include <algorithm>
#include <stdexcept>

namespace plica {

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

double temperature_at(const PartTemperature& part, double y) {
  if (part.at) return *part.at;
  return at_temperature(part.along, std::clamp(y, part.along.front()[0], part.along.back()[0]));
}

const std::vector<Steel>& steels() {
  // EN 10088-1:2005, annex: E and mean expansion from 20 degC to the temperature, which the table
  // begins at 100 degC; that of 20 degC is taken as its first.
  static const std::vector<std::array<double, 2>> austenitic_E{
      {20, 200e9}, {100, 194e9}, {200, 186e9}, {300, 179e9}, {400, 172e9}, {500, 165e9}};
  static const std::vector<std::array<double, 2>> austenitic_expansion{
      {20, 16.0e-6},  {100, 16.0e-6}, {200, 16.5e-6},
      {300, 17.0e-6}, {400, 17.5e-6}, {500, 18.0e-6}};
  // Special Metals, publication SMC-063: annealed, dynamic modulus; mean expansion from 21 degC.
  static const std::vector<std::array<double, 2>> alloy_625_E{
      {21, 207.5e9},  {93, 204.1e9},  {204, 197.9e9}, {316, 191.7e9}, {427, 185.5e9},
      {538, 178.6e9}, {649, 170.3e9}, {760, 160.6e9}, {871, 147.5e9}};
  static const std::vector<std::array<double, 2>> alloy_625_expansion{
      {21, 12.8e-6},  {93, 12.8e-6},  {204, 13.1e-6}, {316, 13.3e-6}, {427, 13.7e-6},
      {538, 14.0e-6}, {649, 14.8e-6}, {760, 15.3e-6}, {871, 15.8e-6}};
  static const char* const standard = "EN 10088-1, annex";
  const auto austenitic = [](double rho) {
    return Material{.E = 200e9,
                    .nu = 0.3,
                    .rho = rho,
                    .E_over_temperature = austenitic_E,
                    .expansion = austenitic_expansion};
  };
  static const std::vector<Steel> all{{"1.4301", austenitic(7900), standard},
                                      {"1.4541", austenitic(7900), standard},
                                      {"1.4404", austenitic(8000), standard},
                                      {"2.4856",
                                       {.E = 207.5e9,
                                        .nu = 0.278,
                                        .rho = 8440,
                                        .E_over_temperature = alloy_625_E,
                                        .expansion = alloy_625_expansion},
                                       "Special Metals, SMC-063 (Inconel 625)"}};
  return all;
}

std::string material_of(const Part& part) {
  if (const auto* bellows = std::get_if<Bellows>(&part.body)) return bellows->material;
  if (const auto* plate = std::get_if<Plate>(&part.body)) return plate->material;
  if (const auto* surface = std::get_if<SurfacePart>(&part.body)) return surface->material;
  if (const auto* beam = std::get_if<BeamPart>(&part.body)) return beam->section.material;
  return "";
}

void add_known_steels(const std::vector<Part>& parts, std::map<std::string, Material>& materials) {
  for (const Part& part : parts)
    for (const Steel& steel : steels())
      if (material_of(part) == steel.name) materials.try_emplace(steel.name, steel.material);
}

} // namespace plica

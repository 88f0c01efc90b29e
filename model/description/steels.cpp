#include "model/description/steels.hpp"

namespace plica {
namespace {

// EN 10088-1:2005, annex: E and mean expansion from 20 degC to the temperature, which the table
// begins at 100 degC; that of 20 degC is taken as its first. Conductivity EN 1993-1-2:2005, annex
// C.3.3: 14.6 + 0.0127 T of stainless steels, 20 to 1200 degC.
Steel austenitic(const char* name, double rho) {
  return {name,
          {.E = 200e9,
           .nu = 0.3,
           .rho = rho,
           .E_over_temperature =
               {{20, 200e9}, {100, 194e9}, {200, 186e9}, {300, 179e9}, {400, 172e9}, {500, 165e9}},
           .expansion = {{20, 16.0e-6},
                         {100, 16.0e-6},
                         {200, 16.5e-6},
                         {300, 17.0e-6},
                         {400, 17.5e-6},
                         {500, 18.0e-6}},
           .conductivity = {{20, 14.854}, {1200, 29.84}}},
          "EN 10088-1, annex; conductivity EN 1993-1-2, annex C"};
}

// E of ASME B31.3, table C-6: austenitic steels TP304 to TP310, between which 1.4828 (20 % Cr, 12 %
// Ni) lies; 70 to 1500 degF, 1 Msi = 6.89476 GPa. EN 10095:1999, annex: mean expansion from 20
// degC, begun at 200 degC; conductivity at 20 and 500 degC.
Steel heat_resisting() {
  return {"1.4828",
          {.E = 195.1e9,
           .nu = 0.3,
           .rho = 7900,
           .E_over_temperature = {{21, 195.1e9},
                                  {260, 177.9e9},
                                  {316, 174.4e9},
                                  {371, 171.0e9},
                                  {427, 166.2e9},
                                  {482, 162.0e9},
                                  {538, 157.2e9},
                                  {593, 152.4e9},
                                  {649, 146.2e9},
                                  {704, 139.3e9},
                                  {760, 132.4e9},
                                  {816, 124.8e9}},
           .expansion = {{20, 16.5e-6},
                         {200, 16.5e-6},
                         {400, 17.5e-6},
                         {600, 18.0e-6},
                         {800, 18.5e-6},
                         {1000, 19.5e-6}},
           .conductivity = {{20, 15}, {500, 21}}},
          "EN 10095, annex; E of austenitic steels, ASME B31.3"};
}

// Special Metals, publication SMC-063: annealed; dynamic modulus, mean expansion from 21 degC,
// Poisson's ratio and thermal conductivity.
Steel alloy_625() {
  return {"2.4856",
          {.E = 207.5e9,
           .nu = 0.278,
           .rho = 8440,
           .E_over_temperature = {{21, 207.5e9},
                                  {93, 204.1e9},
                                  {204, 197.9e9},
                                  {316, 191.7e9},
                                  {427, 185.5e9},
                                  {538, 178.6e9},
                                  {649, 170.3e9},
                                  {760, 160.6e9},
                                  {871, 147.5e9}},
           .expansion = {{21, 12.8e-6},
                         {93, 12.8e-6},
                         {204, 13.1e-6},
                         {316, 13.3e-6},
                         {427, 13.7e-6},
                         {538, 14.0e-6},
                         {649, 14.8e-6},
                         {760, 15.3e-6},
                         {871, 15.8e-6}},
           .nu_over_temperature = {{21, 0.278},
                                   {93, 0.280},
                                   {204, 0.286},
                                   {316, 0.290},
                                   {427, 0.295},
                                   {538, 0.305},
                                   {649, 0.321},
                                   {760, 0.340},
                                   {871, 0.336}},
           .conductivity = {{21, 9.8},
                            {38, 10.1},
                            {93, 10.8},
                            {204, 12.5},
                            {316, 14.1},
                            {427, 15.7},
                            {538, 17.5},
                            {649, 19.0},
                            {760, 20.8},
                            {871, 22.8}}},
          "Special Metals, SMC-063 (Inconel 625)"};
}

} // namespace

const std::vector<Steel>& steels() {
  static const std::vector<Steel> all{austenitic("1.4301", 7900), austenitic("1.4541", 7900),
                                      austenitic("1.4404", 8000), heat_resisting(), alloy_625()};
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

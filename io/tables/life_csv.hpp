// Tables of stress by place and of fatigue life (csv.hpp says how they are written).
#pragma once

#include "run/results/results.hpp"

#include <string>

namespace plica {

std::string stress_places_csv(const Results& results);   // every load case, place, face and ply
std::string life_meridian_csv(const Results& results);   // damage along the wall, through the worst
std::string stress_meridian_csv(const Results& results); // along the wall through the hottest point
std::string life_csv(const Results& results);            // every place and face, most damage first
std::string life_duties_csv(const Results& results);
std::string life_density_csv(const DutyResult& duty); // needs `random`

std::string life_density_file(const std::string& duty); // "life_density_road.csv"

} // namespace plica

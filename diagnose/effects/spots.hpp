// Places of a structure where something may touch it or sit on it.
#pragma once

#include "diagnose/effects/effect.hpp"
#include "diagnose/effects/spot.hpp"

namespace plica {

// Of what acts at one place: so many crowns or convolutions are looked at, the others where these
// come near.
inline constexpr int local_stations = 10;
// Numbers of 1..count that are looked at: all, or eight evenly spread, and up to `most` between.
std::vector<int> stations_of(int count, int most = 8);
// Of "PREFIX[number]" among the stations given, in increasing order; empty for one of them.
PlaceShares between_stations(const std::string& prefix, const std::vector<int>& stations, int number);
// Sensors, and up to eight stations along every shell of revolution, pipe, chain and beam.
std::vector<Spot> spots(const Structure& s);
// Where something may touch or sit: these, of bellows all crowns, a grid on every plate
// (plate_spots.hpp), and nodes all over what is read from a file (wall_spots.hpp).
std::vector<Spot> contact_spots(const Structure& s);
// Where a sensor sits a mass is told of the sensor; where several do, of each.
bool is_told_of_sensor(const Structure& s, const Spot& spot);

} // namespace plica

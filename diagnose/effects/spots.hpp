// Places of a structure where something may touch it or sit on it.
#pragma once

#include "diagnose/effects/effect.hpp"
#include "diagnose/effects/spot.hpp"

namespace plica {

// Of what acts at one place: of up to 32 crowns or convolutions each is looked at or lies next to
// one that is.
inline constexpr int local_stations = 16;
// Numbers of 1..count that are looked at: all, or so many evenly spread.
std::vector<int> stations_of(int count, int most = 8);
struct ConvolutionPlace {
  int number = 1;
  std::string place;
  PlaceShares between;
};
// Of a bellows all 1..count: first up to `most` stations, then each other one between two of these,
// or beside the first or the last.
std::vector<ConvolutionPlace> convolution_places(const std::string& part, int count,
                                                 int most = local_stations);
// Sensors, and up to eight stations along every shell of revolution, pipe, chain and beam.
std::vector<Spot> spots(const Structure& s);
// Where something may touch or sit: these, of bellows every crown, a grid on every plate
// (plate_spots.hpp), and nodes all over what is read from a file (wall_spots.hpp); of one part
// alone, or of all and the sensors.
std::vector<Spot> contact_spots(const Structure& s, const std::string& part_alone = "");
// Where a sensor sits a mass is told of the sensor; where several do, of each.
bool is_told_of_sensor(const Structure& s, const Spot& spot);

} // namespace plica

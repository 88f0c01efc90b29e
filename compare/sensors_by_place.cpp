#include "compare/sensors_by_place.hpp"

#include "words/directions.hpp"
#include "words/units.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

namespace plica {
namespace {

struct Renamed {
  const MeasuredSensor* as;
  std::string was;
};

// Channels of one sensor in the axes of another: new name and sign; empty name = it stays.
std::pair<std::string, double> channel_as(const std::string& channel,
                                          const std::vector<Renamed>& list) {
  if (!is_translation(channel)) return {"", 1};
  for (const Renamed& r : list) {
    if (sensor_of_channel(channel) != r.was) continue;
    for (std::size_t k = 0; k < 3; ++k)
      if (axis_of_signed(r.as->axes[k]) == axis_of_channel(channel))
        return {r.as->name + "." + axis_word(int(k)), sign_of(r.as->axes[k])};
  }
  return {"", 1};
}

} // namespace

Measured named_by_place(Measured test, const Measured& simulated, double reach) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> near;
  for (std::size_t i = 0; i < test.sensors.size(); ++i) {
    if (!test.sensors[i].on.empty()) continue; // beside the part
    for (std::size_t j = 0; j < simulated.sensors.size(); ++j) {
      const auto at = [](const MeasuredSensor& s) {
        return Eigen::Map<const Eigen::Vector3d>(s.at.data());
      };
      const double distance = (at(test.sensors[i]) - at(simulated.sensors[j])).norm();
      if (distance <= reach) near.emplace_back(distance, i, j);
    }
  }
  std::sort(near.begin(), near.end());
  std::vector<char> taken(test.sensors.size(), 0), given(simulated.sensors.size(), 0);
  for (std::size_t j = 0; j < given.size(); ++j)
    for (std::size_t i = 0; i < taken.size(); ++i)
      if (test.sensors[i].name == simulated.sensors[j].name) taken[i] = given[j] = 1;
  std::vector<Renamed> renamed;
  for (const auto& [distance, i, j] : near) {
    if (taken[i] || given[j]) continue;
    taken[i] = given[j] = 1;
    renamed.push_back({&simulated.sensors[j], test.sensors[i].name});
    test.sensors[i].name = simulated.sensors[j].name;
    test.sensors[i].axes = simulated.sensors[j].axes;
  }
  for (MeasuredMode& mode : test.modes) {
    if (!mode.vector) continue;
    for (std::size_t c = 0; c < mode.vector->channels.size(); ++c) {
      const auto [name, sign] = channel_as(mode.vector->channels[c], renamed);
      if (name.empty()) continue;
      mode.vector->channels[c] = name;
      mode.vector->real[c] *= sign;
      if (!mode.vector->imaginary.empty()) mode.vector->imaginary[c] *= sign;
    }
  }
  test.caveats.push_back(std::to_string(renamed.size()) + " of " +
                         std::to_string(test.sensors.size()) + " nodes stand within " +
                         short_number(1e3 * reach) +
                         " mm of a sensor of the simulation, and are called "
                         "as it");
  return test;
}

} // namespace plica

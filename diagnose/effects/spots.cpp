#include "diagnose/effects/spots.hpp"

#include "diagnose/effects/places.hpp"
#include "diagnose/effects/plate_spots.hpp"
#include "diagnose/effects/wall_spots.hpp"
#include "model/description/place_keys.hpp"

#include <algorithm>

namespace plica {
namespace {

// The widest ring between two places along the axis; none = null.
const Ring* crown(const Mesh& mesh, double from, double to) {
  const Ring* widest = nullptr;
  for (const Ring& ring : mesh.rings)
    if (ring.y > from && ring.y < to && (!widest || ring.radius > widest->radius)) widest = &ring;
  return widest;
}

// Its uppermost node: what touches from above touches there.
int top_of(const Mesh& mesh, const std::vector<int>& nodes) {
  return *std::max_element(nodes.begin(), nodes.end(),
                           [&](int a, int b) { return mesh.nodes[a].z() < mesh.nodes[b].z(); });
}

// Those looked at, or all.
void add_convolutions(std::vector<Spot>& found, const Structure& s, const std::string& part,
                      int looked_at, bool all) {
  const Mesh& mesh = s.built.model.mesh;
  const std::vector<double> y = roots(mesh, part);
  const int count = int(y.size()) - 1;
  const std::vector<int> stations = stations_of(count, looked_at);
  const std::string prefix = part + ".convolution";
  for (int k = 1; k <= count; ++k) {
    PlaceShares between = between_stations(prefix, stations, k);
    if (!all && !between.empty()) continue;
    if (const Ring* ring = crown(mesh, y[std::size_t(k) - 1], y[std::size_t(k)]))
      found.push_back({.place = prefix + "[" + std::to_string(k) + "]",
                       .nodes = ring->nodes,
                       .touched = top_of(mesh, ring->nodes),
                       .between = std::move(between)});
  }
}

void add_points(std::vector<Spot>& found, const Structure& s, const std::string& part) {
  const auto& sets = s.built.model.mesh.sets;
  int points = 0;
  while (sets.contains(part + ".point[" + std::to_string(points + 1) + "]")) ++points;
  for (int k : stations_of(points)) {
    const std::string place = part + ".point[" + std::to_string(k) + "]";
    found.push_back({place, sets.at(place), sets.at(place).front(), true});
  }
}

void add_along(std::vector<Spot>& found, const Structure& s, const std::string& part) {
  const std::vector<int>& nodes = s.built.model.mesh.sets.at(part + ".all");
  if (nodes.size() < 3) return;
  for (int k : stations_of(int(nodes.size()) - 2))
    found.push_back({part + ".node[" + std::to_string(k) + "]",
                     {nodes[std::size_t(k)]},
                     nodes[std::size_t(k)],
                     true});
}

bool is_held(const Structure& s, int node) {
  return std::find(s.built.held_nodes.begin(), s.built.held_nodes.end(), node) !=
         s.built.held_nodes.end();
}

} // namespace

std::vector<int> stations_of(int count, int most) {
  std::vector<int> chosen;
  const int even = std::min(count, 8);
  for (int i = 0; i < even; ++i)
    chosen.push_back(even == count ? i + 1 : 1 + ((2 * i + 1) * count) / (2 * even));
  const auto away = [&](int k) {
    int nearest = count;
    for (int other : chosen) nearest = std::min(nearest, std::abs(other - k));
    return nearest;
  };
  while (int(chosen.size()) < std::min(count, most)) {
    int farthest = 1;
    for (int k = 2; k <= count; ++k)
      if (away(k) > away(farthest)) farthest = k;
    chosen.insert(std::upper_bound(chosen.begin(), chosen.end(), farthest), farthest);
  }
  return chosen;
}

PlaceShares between_stations(const std::string& prefix, const std::vector<int>& stations, int number) {
  const auto place = [&](int k) { return prefix + "[" + std::to_string(k) + "]"; };
  const auto next = std::lower_bound(stations.begin(), stations.end(), number);
  if (next == stations.end()) return {{place(stations.back()), 1}};
  if (*next == number) return {};
  if (next == stations.begin()) return {{place(*next), 1}};
  const int before = *(next - 1);
  const double share = double(number - before) / double(*next - before);
  return {{place(before), 1 - share}, {place(*next), share}};
}

namespace {

enum class Where { few, anything_touches };

std::vector<Spot> spots_of(const Structure& s, Where where) {
  const bool all = where == Where::anything_touches;
  std::vector<Spot> found;
  for (const BuiltSensor& sensor : s.built.sensors)
    found.push_back({sensor_place(sensor.name), {sensor.node}, sensor.node});
  for (const Part& part : s.data.parts) {
    if (std::holds_alternative<Bellows>(part.body))
      add_convolutions(found, s, part.name, all ? local_stations : 8, all);
    if (std::holds_alternative<BeamPart>(part.body)) add_points(found, s, part.name);
    if (std::holds_alternative<EquivalentPipe>(part.body) ||
        std::holds_alternative<ConnectorChain>(part.body))
      add_along(found, s, part.name);
    if (!all) continue;
    if (const auto* plate = std::get_if<Plate>(&part.body))
      for (Spot& spot : plate_spots(s.built, part.name, *plate)) found.push_back(std::move(spot));
    if (std::holds_alternative<SurfacePart>(part.body) ||
        std::holds_alternative<DeckPart>(part.body))
      for (Spot& spot : wall_spots(s.built, part.name)) found.push_back(std::move(spot));
  }
  std::erase_if(found, [&](const Spot& spot) { return is_held(s, spot.touched); });
  return found;
}

} // namespace

std::vector<Spot> spots(const Structure& s) {
  return spots_of(s, Where::few);
}

std::vector<Spot> contact_spots(const Structure& s) {
  return spots_of(s, Where::anything_touches);
}

bool is_told_of_sensor(const Structure& s, const Spot& spot) {
  const auto& sensors = s.built.sensors;
  return !is_at_sensor(spot.place) &&
         std::any_of(sensors.begin(), sensors.end(),
                     [&](const BuiltSensor& sensor) { return sensor.node == spot.touched; });
}

} // namespace plica

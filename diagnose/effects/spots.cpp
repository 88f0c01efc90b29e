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

std::string convolution_place(const std::string& part, int k) {
  return part + ".convolution[" + std::to_string(k) + "]";
}

void add_crowns(std::vector<Spot>& found, const Structure& s, const std::string& part, int most) {
  const Mesh& mesh = s.built.model.mesh;
  const std::vector<double> y = roots(mesh, part);
  for (const ConvolutionPlace& c : convolution_places(part, int(y.size()) - 1, most))
    if (const Ring* ring = crown(mesh, y[std::size_t(c.number) - 1], y[std::size_t(c.number)]))
      found.push_back({.place = c.place,
                       .nodes = ring->nodes,
                       .touched = top_of(mesh, ring->nodes),
                       .between = c.between});
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
  const int even = std::min(count, most);
  for (int i = 0; i < even; ++i) chosen.push_back(1 + ((2 * i + 1) * count) / (2 * even));
  return chosen;
}

std::vector<ConvolutionPlace> convolution_places(const std::string& part, int count, int most) {
  std::vector<ConvolutionPlace> found;
  const std::vector<int> looked_at = stations_of(count, most);
  for (int k : looked_at)
    found.push_back({.number = k, .place = convolution_place(part, k), .between = {}});
  for (int k = 1; k <= count; ++k) {
    const auto after = std::lower_bound(looked_at.begin(), looked_at.end(), k);
    if (after != looked_at.end() && *after == k) continue;
    const int before = after == looked_at.begin() ? *after : *std::prev(after);
    const int next = after == looked_at.end() ? before : *after;
    const double share = next == before ? 0 : double(k - before) / double(next - before);
    PlaceShares between{{convolution_place(part, before), 1 - share}};
    if (share > 0) between.emplace_back(convolution_place(part, next), share);
    found.push_back({.number = k, .place = convolution_place(part, k), .between = between});
  }
  return found;
}

namespace {

void add_spots_of(std::vector<Spot>& found, const Structure& s, const Part& part, int crowns) {
  if (std::holds_alternative<Bellows>(part.body)) add_crowns(found, s, part.name, crowns);
  if (std::holds_alternative<BeamPart>(part.body)) add_points(found, s, part.name);
  if (std::holds_alternative<EquivalentPipe>(part.body) ||
      std::holds_alternative<ConnectorChain>(part.body))
    add_along(found, s, part.name);
}

void add_walls_of(std::vector<Spot>& found, const Structure& s, const Part& part) {
  const auto add = [&](std::vector<Spot> spots) {
    for (Spot& spot : spots) found.push_back(std::move(spot));
  };
  if (const auto* plate = std::get_if<Plate>(&part.body))
    add(plate_spots(s.built, part.name, *plate));
  if (is_from_file(part)) add(wall_spots(s.built, part.name));
}

std::vector<Spot> sensor_spots(const Structure& s) {
  std::vector<Spot> found;
  for (const BuiltSensor& sensor : s.built.sensors)
    found.push_back({sensor_place(sensor.name), {sensor.node}, sensor.node});
  return found;
}

void drop_held(std::vector<Spot>& spots, const Structure& s) {
  std::erase_if(spots, [&](const Spot& spot) { return is_held(s, spot.touched); });
}

} // namespace

std::vector<Spot> spots(const Structure& s) {
  constexpr int few = 8;
  std::vector<Spot> found = sensor_spots(s);
  for (const Part& part : s.data.parts) add_spots_of(found, s, part, few);
  std::erase_if(found, [](const Spot& spot) { return !spot.between.empty(); });
  drop_held(found, s);
  return found;
}

std::vector<Spot> contact_spots(const Structure& s, const std::string& part_alone) {
  std::vector<Spot> found;
  if (part_alone.empty()) found = sensor_spots(s);
  for (const Part& part : s.data.parts) {
    if (!part_alone.empty() && part.name != part_alone) continue;
    add_spots_of(found, s, part, local_stations);
    add_walls_of(found, s, part);
  }
  drop_held(found, s);
  return found;
}

bool is_told_of_sensor(const Structure& s, const Spot& spot) {
  const auto& sensors = s.built.sensors;
  return !is_at_sensor(spot.place) &&
         std::any_of(sensors.begin(), sensors.end(),
                     [&](const BuiltSensor& sensor) { return sensor.node == spot.touched; });
}

} // namespace plica

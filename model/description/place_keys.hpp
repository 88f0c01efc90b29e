// Where parts, caps and mounts stand in a case: "parts.interlock", "caps.left", "mount.left".
// Springs of caps and mounts are components of the model by these names, and effects have them as
// places.
#pragma once

#include <optional>
#include <string>

namespace plica {

inline std::string part_key(const std::string& part) {
  return "parts." + part;
}
inline std::string cap_key(const std::string& cap) {
  return "caps." + cap;
}
// The springs of one of its ends: "caps.flange.pipe.end".
inline std::string sprung_end_key(const std::string& cap, const std::string& end) {
  return cap_key(cap) + "." + end;
}
inline std::string mount_key(const std::string& cap) {
  return "mount." + cap;
}
// The springs by which a liner leans on the wall: a component and a place.
inline std::string contact_place(const std::string& liner) {
  return liner + ".contact";
}
inline constexpr const char* all_mounts = "mount"; // a place: all that hold the part

inline bool is_at_cap(const std::string& key) {
  return key.starts_with("caps.");
}
inline bool is_at_mount(const std::string& key) {
  return key.starts_with("mount.");
}
// Of a component: only caps and mounts have springs by themselves.
inline bool is_springs(const std::string& component) {
  return is_at_cap(component) || is_at_mount(component);
}
// "left" of "caps.left" and of "mount.left".
inline std::string cap_of(const std::string& key) {
  return key.substr(key.find('.') + 1);
}

// A place of effects: where a sensor sits, or the sensor itself.
inline std::string sensor_place(const std::string& sensor) {
  return "sensor." + sensor;
}
inline bool is_at_sensor(const std::string& place) {
  return place.starts_with("sensor.");
}

// "bellows" of "bellows.left": a set of it, or a place in it.
inline std::string part_of_set(const std::string& set) {
  return set.substr(0, set.find('.'));
}

// A path below one of them: of "caps.left.mass" a cap, "left" and "mass".
enum class PlaceKind { part, cap, mount };
struct PathInPlace {
  PlaceKind kind = PlaceKind::part;
  std::string name, key;
};
// None of another path, and of one that ends with the name.
std::optional<PathInPlace> path_in_place(const std::string& path);

} // namespace plica

// Units as test systems write them beside their numbers: axes of universal files, headers of CSV,
// texts in MATLAB files.
//
//   m/s^2  m/s2  m/s**2  m/s/s  mm/s²  in/sec^2  ips2  g  (m/s^2)/N  g/lbf  1/min  RPM
//
// Products and quotients of known units; "a per b" is a/(b). Units of the case file keep their one
// table (words/units.cpp), those of laboratories stand beside it. g is the acceleration of
// gravity, lb a force. Capitals do not matter where only one unit is meant: MM is mm, but a lower
// case mn is neither mN nor MN.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace plica {

// Exponents of the units kg, m, s, rad.
struct UnitPowers {
  int mass = 0, length = 0, time = 0, angle = 0;
  friend bool operator==(const UnitPowers&, const UnitPowers&) = default;
  friend constexpr UnitPowers operator-(const UnitPowers& a, const UnitPowers& b) {
    return {a.mass - b.mass, a.length - b.length, a.time - b.time, a.angle - b.angle};
  }
};

namespace powers {
inline constexpr UnitPowers none{}, displacement{.length = 1}, velocity{.length = 1, .time = -1},
    acceleration{.length = 1, .time = -2}, force{.mass = 1, .length = 1, .time = -2},
    moment{.mass = 1, .length = 2, .time = -2}, pressure{.mass = 1, .length = -1, .time = -2},
    time{.time = 1}, frequency{.time = -1}, turning_speed{.time = -1, .angle = 1},
    angle{.angle = 1}, angular_acceleration{.time = -2, .angle = 1};
}

struct LabUnit {
  double factor = 1; // SI = factor * number
  UnitPowers powers;
};

// Nothing for a text that is no unit that is known.
std::optional<LabUnit> lab_unit(std::string_view text);

// "", "NONE", "-", "unknown", "EU" and their like.
bool states_no_unit(std::string_view text);

// Hz of an abscissa in that unit, or nothing when it is none of frequency: rpm and rad/s are.
std::optional<double> hertz_of(const LabUnit& unit);

// "acceleration", "force"; "unit of none of the known quantities".
std::string name_of(const UnitPowers& powers);

// For messages: what may be written.
std::string known_lab_units();

} // namespace plica

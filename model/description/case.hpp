// A case: what is drawn, how it is held, where it is watched, and what is asked of it.
//
// Plain data in SI units (m, kg, s, N, Pa, rad; frequencies in Hz; ratios as numbers, 1 % = 0.01).
// Part frame: y along the pipe, x transverse, z vertical. Lengths of a wall are mid-surface
// lengths. The YAML keys, their units, bounds and meaning are described once, in case_fields.hpp.
#pragma once

#include "model/description/analyses.hpp"
#include "model/description/diagnosis_request.hpp"
#include "model/description/fit_request.hpp"
#include "model/description/operating_state.hpp"
#include "model/description/parts.hpp"
#include "model/description/spring_damping.hpp"

#include <map>

namespace plica {

// An end that hangs on springs of its own at its cap, such as one of several bolts.
struct SprungEnd {
  std::string end = {}; // one of those that the cap joins
  Sextuple stiffness{};
  std::optional<JointFriction> friction = {}; // beside these springs
  std::optional<SpringDamping> damping = {};  // of these springs
};

// Rigid end cap or flange: reference node in the middle of an end circle, tied to it. On the ends
// of several parts it joins them, a clamp.
struct Cap {
  std::string name;
  std::vector<std::string> of = {}; // sets it closes, e.g. "bellows.left"
  std::optional<Sextuple> stiffness =
      {}; // springs between the first end and the others; none = rigid
  std::optional<JointFriction> friction = {}; // beside these springs
  std::optional<SpringDamping> damping = {};  // of these springs
  std::vector<SprungEnd> ends = {};           // on springs of their own; the others are rigid
  double mass = 0;
  Sextuple inertia{}; // about its centre of mass, kg m2
  Triple offset{};    // reference node to centre of mass
};

bool hangs_on_springs(const Cap& cap, const std::string& end); // of its own (SprungEnd)

enum class MountKind { free, rigid, springs };

struct Mount {
  std::string cap;
  MountKind kind = MountKind::rigid;
  Sextuple stiffness{};                       // springs: N/m, N/m, N/m, Nm/rad, Nm/rad, Nm/rad
  std::optional<JointFriction> friction = {}; // beside these springs
  std::optional<SpringDamping> damping = {};  // of these springs
};

// Degrees of freedom of a set held to zero.
struct Support {
  std::string set;
  std::vector<int> dofs; // 0..5 = ux uy uz rx ry rz
};

inline constexpr double sensor_reach = 5e-3; // m, from a sensor to the part it sits on

struct Sensor {
  std::string name;
  Triple at{};                    // sits on the nearest node; one farther than `reach` is an error
  std::vector<int> axes{1, 2, 3}; // its own three axes: 1 x, 2 y, 3 z, negative = reversed
  double mass = 0;                // rides on that node
  double reach = sensor_reach;    // m, how far the nearest node may be
  // Of a test: what it sits on beside the part, MeasuredSensor::on; empty = the part.
  std::string on = {};
  bool if_there = false; // of a test: left out where the part is not within `reach`
};

// The same case with some numbers changed: shown beside the nominal results.
struct Variant {
  std::string name;
  std::map<std::string, std::string> set; // path of the case file: new value, as written there
};

// The same component by another kind of model: these sections replace those of the case; an empty
// one is kept as it is. After that, what `set` changes.
struct AlternativeModel {
  std::string name;                       // "pipe", "connector", "friction", ...
  std::map<std::string, std::string> set; // path of the case file: new value, as written there
  std::vector<std::string> assumptions;
  std::vector<Part> parts;
  std::vector<Cap> caps;
  std::vector<Mount> mount;
  std::vector<Sensor> sensors;
  std::vector<Variant> variants;
  std::optional<FitRequest> fit;
};

// A number known only within limits, from "8 mm +- 1 mm" (evenly within them) or
// "3 kN [0.3, 30]" (half of the probability on each side of the value, on a log scale when both
// limits are above zero). Values in SI.
struct Tolerance {
  std::string path; // of the number in the case file
  double value = 0, low = 0, high = 0;
  bool interval = false; // written as [low, high]
};

struct Case {
  std::string name;
  std::string model; // alternative model that it is; empty = as the parts of the case say
  std::string title;
  std::vector<std::string> assumptions; // in words, printed in the report
  std::map<std::string, Material> materials;
  std::vector<Part> parts;
  std::vector<Cap> caps;
  std::vector<Mount> mount;
  std::vector<Support> supports;
  std::vector<Sensor> sensors;
  std::optional<OperatingState> state;
  std::vector<OperatingState> states; // by name, shown beside one another
  Analyses analyses;
  std::vector<Variant> variants;
  std::optional<FitRequest> fit;
  DiagnosisRequest diagnose;
  std::vector<AlternativeModel> models;
  std::vector<Tolerance> tolerances;
  std::string measured; // path of measured.yaml beside the case file; empty = none
};

// The case in one of its states. Throws InputError when it has none of that name.
Case in_state(const Case& data, const std::string& name);

// True when a part, a joint, a mount or the plies of a wall have friction or a nonlinear spring.
bool has_friction(const Case& data);

// True when springs of a joint or of a mount are damped.
bool has_damped_springs(const Case& data);

// A deck that holds some of its nodes; one that could not be read may.
bool held_by_deck(const Case& data);

} // namespace plica

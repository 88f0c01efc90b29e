#include "model/description/case_checks.hpp"

#include "model/description/check_log.hpp"
#include "model/description/friction_checks.hpp"
#include "model/description/life_checks.hpp"
#include "model/description/node_sets.hpp"
#include "model/description/operating_state_checks.hpp"
#include "model/description/part_checks.hpp"
#include "model/description/place_keys.hpp"
#include "model/description/profile.hpp"
#include "model/description/response_checks.hpp"
#include "model/description/spring_damping_checks.hpp"
#include "words/did_you_mean.hpp"
#include "words/units.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace plica {

namespace {

void check_sprung_ends(const Cap& cap, CheckLog& log) {
  const std::string key = cap_key(cap.name);
  if (cap.stiffness && !cap.ends.empty())
    log.add(key + ".ends",
            "stand beside `stiffness`, the springs between the first end and all "
            "others",
            "one of the two");
  std::set<std::string> sprung;
  for (std::size_t i = 0; i < cap.ends.size(); ++i) {
    const std::string place = item(key + ".ends", i) + ".end";
    if (!log.fine(place) || !log.fine(key + ".of")) continue;
    log.reference(place, "end of this cap", cap.ends[i].end, cap.of);
    log.once(sprung, cap.ends[i].end, place, "end");
  }
}

void check_caps(const Case& data, CheckLog& log) {
  std::map<std::string, std::string> closed;
  for (const Cap& cap : data.caps) {
    const std::string key = cap_key(cap.name);
    for (const std::string& end : cap.of) {
      log.reference(key + ".of", "end", end, end_names(data));
      if (log.fine(key + ".of") && !closed.emplace(end, cap.name).second)
        log.add(key + ".of", end + " is already closed by cap '" + closed[end] + "'",
                "one cap per end");
    }
    if (cap.stiffness && cap.of.size() < 2 && log.fine(key + ".of"))
      log.add(key + ".stiffness", "is that of a joint, and the cap joins nothing",
              "give of: [first end, second end]");
    check_sprung_ends(cap, log);
    check_inertia(key + ".inertia", cap.inertia, log);
  }
}

void check_mount(const Case& data, CheckLog& log) {
  std::vector<std::string> names;
  for (const Cap& cap : data.caps) names.push_back(cap.name);
  if (!log.fine("caps")) return;
  for (const Mount& m : data.mount) log.reference(mount_key(m.cap), "cap", m.cap, names);
}

// Distance of a point from the box or ring a part lies in; the mesh gives the exact one later.
double distance(const Triple& x, const Bellows& b) {
  const auto [low, high] = radius_range(b);
  const double r = std::hypot(x[0], x[2]), end = b.start + axial_length(b);
  const double dr = std::max({low - r, r - high, 0.0});
  return std::hypot(dr, std::max({b.start - x[1], x[1] - end, 0.0}));
}
template <class Points> double box_distance(const Triple& x, const Points& points) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    double low = x[k], high = x[k];
    if (!points.empty()) low = high = points[0][k];
    for (const Triple& p : points) {
      low = std::min(low, p[k]);
      high = std::max(high, p[k]);
    }
    const double d = std::max({low - x[k], x[k] - high, 0.0});
    sum += d * d;
  }
  return std::sqrt(sum);
}
double distance(const Triple& x, const Plate& p) {
  return box_distance(x, p.corners);
}
double distance(const Triple&, const SurfacePart&) {
  return 0; // known when it is meshed
}
double distance(const Triple&, const DeckPart&) {
  return 0;
}
// Sections of beams along the axis are rigid: a sensor sits across it where it likes.
double distance(const Triple& x, const BeamPart& b) {
  if (is_on_axis(b)) return box_distance({0, x[1], 0}, b.points);
  return std::max(0., box_distance(x, b.points) - outer_radius(b.section));
}
double section_distance(const Triple& x, double start, double length) {
  const double across = std::max(0.0, std::hypot(x[0], x[2]) - length); // no longer arm than that
  return std::hypot(across, std::max({start - x[1], x[1] - start - length, 0.0}));
}
double distance(const Triple& x, const EquivalentPipe& p) {
  return section_distance(x, p.start, p.length);
}
double distance(const Triple& x, const ConnectorChain& c) {
  return section_distance(x, c.start, c.length);
}
double distance(const Triple&, const Interlock&) {
  return unbounded;
}
double distance(const Triple&, const PointMass&) {
  return unbounded;
}

void check_sensors(const Case& data, CheckLog& log) {
  for (std::size_t i = 0; i < data.sensors.size(); ++i)
    if (const std::string key = item("sensors", i) + ".axes";
        log.fine(key) && !are_three_axes(data.sensors[i].axes))
      log.add(key, "names a direction twice or not at all", three_axes);
  const bool places_known =
      log.fine("parts") && std::none_of(log.problems.begin(), log.problems.end(),
                                        [](const auto& p) { return is_below(p.key, "parts"); });
  for (std::size_t i = 0; i < data.sensors.size(); ++i) {
    const std::string key = item("sensors", i) + ".at";
    if (!places_known || !log.fine(key)) continue;
    double nearest = unbounded;
    std::string name;
    for (const Part& part : data.parts) {
      const double d = std::visit(
          [&](const auto& body) { return distance(data.sensors[i].at, body); }, part.body);
      if (d < nearest) name = part.name;
      nearest = std::min(nearest, d);
    }
    constexpr double rounding = 5e-6; // of what the message shows
    if (nearest > sensor_reach + rounding)
      log.add(key,
              "the sensor is off the part" +
                  (name.empty() ? "" : ": " + millimetres(nearest) + " away from '" + name + "'"),
              "allowed: at most " + millimetres(sensor_reach) + " from the nearest part");
  }
}

void check_analyses(const Case& data, CheckLog& log) {
  const Analyses& a = data.analyses;
  check_responses(data, log);
  const std::size_t n = data.caps.size();
  if (a.statics.value_or(false) && n != 2 && !data.parts.empty() && log.fine("caps") &&
      log.fine("analyses.static"))
    log.add("analyses.static",
            "static stiffness is between two caps, this case has " + std::to_string(n),
            "give exactly two caps, or leave static out");
  if (a.deck_loads && log.fine("parts") && log.fine("analyses.static") &&
      std::none_of(data.parts.begin(), data.parts.end(),
                   [](const Part& p) { return std::holds_alternative<DeckPart>(p.body); }))
    log.add("analyses.static", "is that of the loads of a deck, and no part is one",
            "a part of type: deck, or true");
  if (a.deck_loads && data.state)
    log.add("analyses.static", "is that of the loads of a deck, and the case has a state",
            "the part at rest: leave out state");
  const double highest = highest_frequency(a);
  if (a.reduction && a.reduction->cutoff > 0 && a.reduction->cutoff < highest)
    log.add("analyses.reduction.cutoff", "lies below the highest frequency that is asked for",
            "give twice or three times " + std::to_string(std::lround(highest)) + " Hz");
  if (!a.modes || !log.fine("analyses.modes")) return;
  const bool band = a.modes->band[1] > 0 || a.modes->band[0] > 0;
  if (band == (a.modes->count > 0))
    log.add("analyses.modes", band ? "has a count and a band" : "has neither count nor band",
            "give count (number of modes) or band ([from, to] in Hz)");
  else if (band && a.modes->band[1] <= a.modes->band[0])
    log.add("analyses.modes.band", "ends below its start", "give [from, to] with from below to");
}

void check_names(const Case& data, CheckLog& log) {
  std::set<std::string> sensors, variants;
  for (std::size_t i = 0; i < data.sensors.size(); ++i)
    log.once(sensors, data.sensors[i].name, item("sensors", i) + ".name", "sensor");
  for (std::size_t i = 0; i < data.variants.size(); ++i)
    log.once(variants, data.variants[i].name, item("variants", i) + ".name", "variant");
}

void check_measured(const Case& data, const std::string& directory, CheckLog& log) {
  if (data.measured.empty() || !log.fine("measured")) return;
  std::error_code ignored;
  const auto path = std::filesystem::path(directory) / data.measured;
  if (!std::filesystem::is_regular_file(path, ignored))
    log.add("measured", "there is no file '" + shown(data.measured) + "' beside this one",
            "give a path relative to the case file, or leave the key out");
}

} // namespace

std::vector<InputProblem> check_case(const Case& data, const std::vector<std::string>& bad,
                                     const std::string& directory) {
  CheckLog log(data, bad);
  check_parts(data, log);
  check_caps(data, log);
  check_mount(data, log);
  for (std::size_t i = 0; i < data.supports.size(); ++i)
    log.set_reference(item("supports", i) + ".set", data.supports[i].set);
  check_sensors(data, log);
  check_analyses(data, log);
  check_life(data, log);
  check_friction(data, log);
  check_spring_damping(data, log);
  check_operating_state(data, log);
  check_names(data, log);
  check_measured(data, directory, log);
  return std::move(log.problems);
}

} // namespace plica

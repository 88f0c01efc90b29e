// Which effects are in which set: drawn at random, each specimen by a chance of its own, so that a
// short suite is the beginning of a long one.
#include "../draws.hpp"
#include "sets.hpp"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <numbers>

namespace sealed {
namespace {

using Names = std::vector<std::string>;

bool holds(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// 40, 30 and 30 %, from the first on.
const std::array<const char*, 10> structures_in_turn{
    "short_bellows", "bolted_lap",       "cantilever_masses", "short_bellows",
    "bolted_lap",    "short_bellows",    "cantilever_masses", "bolted_lap",
    "short_bellows", "cantilever_masses"};
const std::array<const char*, 3> strength_names{"weak", "medium", "strong"};

int draw_strength(Draws& draws) {
  const double u = draws.uniform();
  return u < 0.15 ? 0 : u < 0.575 ? 1 : 2;
}

struct Drawn {
  Effect effect;
  std::string strength;
};

// Walls cost minutes: two of each effect, of the mesh road, and damage at the library's angles.
Drawn draw_wall(const std::string& name, int g) {
  g = std::max(g, 1);
  Effect e = graded("short_bellows", name, g, 0).front();
  constexpr double degree = std::numbers::pi / 180;
  if (name == "local_damage") e.value["angle"] = (g == 1 ? 67.5 : 157.5) * degree;
  return {e, strength_names[std::size_t(g)]};
}

Drawn draw_effect(const std::string& structure, Draws& draws) {
  while (true) {
    const std::string name = effect_names()[std::size_t(draws.below(int(effect_names().size())))];
    const int g = draw_strength(draws), variant = draws.below(12);
    const auto found = graded(structure, name, g, variant);
    if (found.empty()) continue;
    if (needs_wall(found.front())) return draw_wall(name, g);
    return {found.front(), strength_names[std::size_t(g)]};
  }
}

// Strangers of a structure: a cantilever shows modes alone, a lap's band begins above an absorber.
const Names& strangers_on(const std::string& structure) {
  static const Names bellows{"clearance", "hardening", "absorber", "left_out"},
      lap{"clearance", "hardening", "left_out"}, cantilever{"absorber", "left_out"};
  return structure == "short_bellows" ? bellows : structure == "bolted_lap" ? lap : cantilever;
}

// The number of a crown or point where something sits, mirror images alike; 0: elsewhere.
int spot(const std::string& structure, const std::string& place) {
  int k = 0;
  if (place.find(".convolution[") != std::string::npos ||
      place.find(".point[") != std::string::npos)
    k = place[place.size() - 2] - '0';
  else if (place == "sensor.mid")
    k = 4;
  else if (place == "sensor.quarter")
    k = 2;
  else if (place.size() == 2 && place[0] == 'm')
    k = place[1] - '0' + 1; // m1 is at beam.point[2]
  return k > 0 && structure == "short_bellows" ? std::min(k, 9 - k) : k;
}

struct SetPlanner {
  std::uint64_t seed = 1;
  Suite suite = {};
  std::map<std::string, int> strange = {}; // how many of a kind on a structure

  void add(const std::string& kind, int index, std::size_t effects, bool has_stranger) {
    Draws draws(seed, fmt::format("sets.{}.{}", kind, index));
    Specimen s{.structure = structures_in_turn[std::size_t(index) % structures_in_turn.size()],
               .kind = kind};
    s.campaign = "sets";
    std::vector<Drawn> drawn;
    if (has_stranger) drawn.push_back(draw_stranger(s, draws));
    const std::size_t whole = drawn.size() + effects;
    while (drawn.size() < whole) {
      const Drawn next = draw_effect(s.structure, draws);
      if (std::all_of(drawn.begin(), drawn.end(), [&](const Drawn& d) {
            return told_apart(s.structure, d.effect, next.effect);
          }))
        drawn.push_back(next);
    }
    if (has_stranger) std::rotate(drawn.begin(), drawn.begin() + 1, drawn.end()); // it comes last
    for (const Drawn& d : drawn) {
      const bool out = &d == &drawn.back() && !s.without.empty();
      s.cls += (s.cls.empty() ? "" : "+") + (out ? "left_out" : d.effect.name);
      s.strength += (s.strength.empty() ? "" : "+") + d.strength;
      if (holds({"joint_friction", "clearance", "hardening"}, d.effect.name)) s.linear = false;
      if (needs_wall(d.effect)) s.wall = wall_of(d.effect, "mesh");
      s.effects.push_back(d.effect);
    }
    if (s.cls.empty()) s.cls = "none";
    if (s.wall.empty() && s.structure == "short_bellows")
      s.wall = fmt::format("healthy_mesh_{}", draws.below(4));
    suite.specimens.push_back(s);
  }

  Drawn draw_stranger(Specimen& s, Draws& draws) {
    const Names& own = strangers_on(s.structure);
    const std::string cls = own[std::size_t(strange[s.kind + s.structure]++) % own.size()];
    if (cls == "left_out") {
      const Drawn d = draw_effect(s.structure, draws);
      s.without = d.effect.name;
      return d;
    }
    const int g = draw_strength(draws); // a variant is a strength and a place
    return {stranger(s.structure, cls, g + 3 * draws.below(4)), strength_names[std::size_t(g)]};
  }
};

} // namespace

std::vector<std::string> alike_to(const std::string& effect) {
  static const std::vector<std::pair<std::string, Names>> alike{
      {"temperature",
       {"damping", "joint_stiffness", "joint_friction", "ply_slip", "forming_thinning"}},
      {"joint_stiffness", {"joint_friction"}},
      {"boundary_compliance", {"fixture_flexibility"}},
      {"unweighed_mass", {"added_mass"}}};
  std::vector<std::string> found;
  for (const auto& [one, others] : alike) {
    if (one == effect) found.insert(found.end(), others.begin(), others.end());
    if (holds(others, effect)) found.push_back(one);
  }
  return found;
}

bool told_apart(const std::string& structure, const Effect& a, const Effect& b) {
  if (holds(alike_to(a.name), b.name)) return false;
  if (needs_wall(a) && needs_wall(b)) return false;
  const int p = spot(structure, a.place), q = spot(structure, b.place);
  const Names at_spots{"added_mass", "component_mass", "extra_support",
                       "clearance",  "hardening",      "absorber"};
  if (p > 0 && p == q && holds(at_spots, a.name) && holds(at_spots, b.name)) return false;
  if (a.name != b.name) return true;
  const Names twice{"added_mass", "component_mass", "extra_support", "rotated_sensor",
                    "sensor_gain"};
  const int apart = structure == "short_bellows" && p > 0 && q > 0 ? 2 : 1;
  return holds(twice, a.name) && a.place != b.place &&
         (p == 0 || q == 0 || std::abs(p - q) >= apart);
}

Suite plan_sets(const SetsPlan& plan) {
  SetPlanner p{.seed = plan.seed};
  p.suite.seed = plan.seed;
  for (int i = 0; i < 3 * plan.rounds; ++i) {
    p.add("triple", i, 3, false);
    p.add("pair", i, 2, false);
    p.add("effect", i, 1, false);
  }
  for (int i = 0; i < 2 * plan.rounds; ++i) {
    p.add("none", i, 0, false);
    p.add("stranger", i, 0, true);
    p.add("known_and_stranger", i, 1, true);
  }
  number_suite(p.suite);
  return p.suite;
}

} // namespace sealed

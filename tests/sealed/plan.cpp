// The list of all specimens: which effect, where, how strong, on which wall; in shuffled order, so
// that a number says nothing.
#include "draws.hpp"
#include "specimen.hpp"

#include <fmt/format.h>
#include <set>
#include <span>

namespace sealed {
namespace {

const std::array<const char*, 3> strengths{"weak", "medium", "strong"};

struct Planner {
  Suite suite;
  int healthy = 0; // walls given out

  std::string healthy_wall(int walls) {
    const int k = healthy++ % walls;
    return fmt::format("healthy_{}_{}", k % 2 ? "mesh" : "calculix", k / 2);
  }

  void add(const std::string& structure, const std::string& kind, const std::string& cls,
           const std::string& strength, const std::vector<Effect>& effects, int walls,
           const std::string& road) {
    Specimen s{
        .structure = structure, .kind = kind, .cls = cls, .strength = strength, .effects = effects};
    for (const Effect& e : effects) {
      if (e.name == "joint_friction" || e.name == "clearance" || e.name == "hardening")
        s.linear = false;
      if (needs_wall(e)) s.wall = wall_of(e, road);
    }
    if (s.wall.empty() && structure == "short_bellows") s.wall = healthy_wall(walls);
    suite.specimens.push_back(s);
  }
};

void plan_effects(Planner& p) {
  for (const std::string& name : effect_names())
    for (int g = 0; g < 3; ++g)
      for (int slot = 0; slot < 3; ++slot) {
        const std::string road = slot % 2 ? "mesh" : "calculix";
        std::string structure = "short_bellows";
        if (slot == 2) // the third on beams where there is such an effect
          for (const char* other : {"bolted_lap", "cantilever_masses"})
            if (!graded(other, name, g, slot).empty() && (structure == "short_bellows" || g != 0))
              structure = other;
        const int variant = structure == "short_bellows" && slot == 2 ? 1 : slot;
        p.add(structure, "effect", name, strengths[std::size_t(g)],
              graded(structure, name, g, variant), 12, road);
      }
}

struct StrangerPlan {
  const char* cls;
  int bellows, lap, cantilever;
};
// Outside of the library by design, and those that look like something in it.
constexpr StrangerPlan beyond_the_library[] = {
    {"clearance", 5, 2, 0}, {"hardening", 5, 2, 0}, {"absorber", 4, 0, 2}};
constexpr StrangerPlan mimics[] = {{"sloshing", 3, 0, 0},       {"coupling_spring", 3, 0, 0},
                                   {"eccentric_mass", 3, 0, 0}, {"rocking_table", 2, 1, 0},
                                   {"time_delay", 2, 0, 0},     {"sensor_resonance", 3, 0, 0},
                                   {"rubber", 3, 0, 0}};

void plan_strangers(Planner& p, std::span<const StrangerPlan> plans, int times = 1) {
  for (const StrangerPlan& plan : plans)
    for (const auto& [structure, count] :
         {std::pair{"short_bellows", plan.bellows}, std::pair{"bolted_lap", plan.lap},
          std::pair{"cantilever_masses", plan.cantilever}})
      for (int v = 0; v < times * count; ++v)
        p.add(structure, "stranger", plan.cls, strengths[std::size_t(v % 3)],
              {stranger(structure, plan.cls, v)}, 12, "");
}

void plan_pairs(Planner& p) {
  const std::array<std::array<const char*, 3>, 8> pairs{{
      {"short_bellows", "ply_slip", "added_mass"},
      {"short_bellows", "joint_stiffness", "damping"},
      {"short_bellows", "boundary_compliance", "sensor_gain"},
      {"short_bellows", "component_mass", "extra_support"},
      {"short_bellows", "joint_friction", "cross_axis_base_motion"},
      {"short_bellows", "fixture_flexibility", "rotated_sensor"},
      {"cantilever_masses", "component_mass", "boundary_compliance"},
      {"bolted_lap", "joint_stiffness", "damping"},
  }};
  for (const auto& [structure, a, b] : pairs)
    for (int v = 0; v < 3; ++v) {
      std::vector<Effect> both = graded(structure, a, 1 + v % 2, v == 1 ? 0 : v);
      const auto second = graded(structure, b, 1 + (v + 1) % 2, v);
      both.insert(both.end(), second.begin(), second.end());
      p.add(structure, "pair", std::string(a) + "+" + b, strengths[std::size_t(1 + v % 2)], both,
            12, v % 2 ? "mesh" : "calculix");
    }
}

void plan_smoke(Planner& p) {
  const auto effect = [&](const char* structure, const char* name, int g, int variant) {
    p.add(structure, "effect", name, strengths[std::size_t(g)], graded(structure, name, g, variant),
          2, "mesh");
  };
  p.add("short_bellows", "none", "none", "", {}, 2, "");
  effect("short_bellows", "joint_stiffness", 2, 0);
  effect("cantilever_masses", "added_mass", 2, 1);
  effect("bolted_lap", "joint_friction", 1, 0);
  effect("cantilever_masses", "component_mass", 2, 0);
  p.add("cantilever_masses", "none", "none", "", {}, 2, "");
  p.add("bolted_lap", "stranger", "hardening", "strong", {stranger("bolted_lap", "hardening", 2)},
        2, "");
}

} // namespace

std::string case_of(const Specimen& s) {
  return s.structure + (s.mounted ? "_mounted" : "") +
         (s.without.empty() ? "" : "_without_" + s.without);
}

bool needs_wall(const Effect& e) {
  return e.name == "ply_slip" || e.name == "forming_thinning" || e.name == "local_damage";
}

std::string wall_of(const Effect& e, const std::string& road) {
  std::string name = e.name + "_" + road;
  for (const auto& [key, value] : e.value) name += fmt::format("_{:.3g}", value);
  return name + (e.place == "bellows" ? "" : fmt::format("_at_{}", e.place[e.place.size() - 2]));
}

void number_suite(Suite& suite) {
  auto& all = suite.specimens;
  Draws draws(suite.seed, "order");
  for (std::size_t i = all.size(); i > 1; --i)
    std::swap(all[i - 1], all[std::size_t(draws.below(int(i)))]);
  std::map<std::string, WallSpecimen> walls;
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].id = fmt::format("{:03}", i + 1);
    if (!all[i].wall.empty()) walls.try_emplace(all[i].wall, wall_specimen(all[i], suite.seed));
  }
  for (const auto& [name, specimen] : walls) suite.walls.push_back({name, specimen});
}

WallSpecimen wall_specimen(const Specimen& s, std::uint64_t seed) {
  WallSpecimen w;
  w.road = s.wall.find("calculix") != std::string::npos ? Road::calculix : Road::mesh;
  Draws draws(seed, "wall." + s.wall);
  w.thickness = 1 + 0.01 * draws.normal();
  double field = draws.normal();
  for (double& E : w.E) { // neighbours alike: correlation 0.8
    E = 1 + 0.02 * field;
    field = 0.8 * field + 0.6 * draws.normal();
  }
  w.bond = value_of(s, "ply_slip", "bellows", "bond", 0.5);
  w.thinning = value_of(s, "forming_thinning", "bellows", "exponent", 0);
  if (const Effect* e = find(s, "local_damage"); e) {
    w.dent = e->place[e->place.size() - 2] - '0';
    w.dent_loss = e->value.at("loss");
    w.dent_angle = e->value.at("angle");
  }
  return w;
}

Suite plan_suite(std::uint64_t seed, bool smoke) {
  Planner p;
  p.suite.seed = seed;
  if (smoke) {
    plan_smoke(p);
  } else {
    for (int i = 0; i < 100; ++i)
      p.add(i < 70   ? "short_bellows"
            : i < 85 ? "cantilever_masses"
                     : "bolted_lap",
            "none", "none", "", {}, 12, "");
    plan_effects(p);
    plan_strangers(p, beyond_the_library);
    plan_strangers(p, mimics);
    plan_pairs(p);
  }
  number_suite(p.suite);
  return p.suite;
}

Suite plan_sixty_strangers(std::uint64_t seed) {
  Planner p;
  p.suite.seed = seed;
  plan_strangers(p, beyond_the_library, 3);
  number_suite(p.suite);
  return p.suite;
}

void keep_beams(Suite& suite) {
  std::erase_if(suite.specimens, [](const Specimen& s) { return s.structure == "short_bellows"; });
  suite.walls.clear();
}

void keep_first(Suite& suite, int count) {
  if (count < int(suite.specimens.size())) suite.specimens.resize(std::size_t(count));
  std::set<std::string> used;
  for (const Specimen& s : suite.specimens) used.insert(s.wall);
  std::erase_if(suite.walls, [&](const auto& wall) { return !used.contains(wall.name); });
}

} // namespace sealed

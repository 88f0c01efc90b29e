// Specimens as labs have them: one end on springs that are known within a tolerance, sensors on the
// held and the sprung end and between the axes of the pairs, each of the levels held out in turn, a
// stated tolerance of damping. Effects, strengths and strangers are those of the suite.
#include "draws.hpp"
#include "specimen.hpp"

#include <fmt/format.h>

namespace sealed {
namespace {

constexpr const char* strengths[] = {"weak", "medium", "strong"};
constexpr int levels = 4;

class MountedPlanner {
public:
  explicit MountedPlanner(std::uint64_t seed) { suite_.seed = seed; }

  void add(const std::string& structure, const std::string& kind, const std::string& cls,
           int strength, std::vector<Effect> effects) {
    Specimen s{.structure = structure,
               .kind = kind,
               .cls = cls,
               .strength = strength < 0 ? "" : strengths[strength],
               .effects = std::move(effects)};
    s.mounted = true;
    s.level_out = count_++ % levels;
    for (const Effect& e : s.effects) {
      if (e.name == "joint_friction" || e.name == "clearance" || e.name == "hardening")
        s.linear = false;
      if (needs_wall(e)) s.wall = wall_of(e, "mesh");
    }
    if (s.wall.empty() && structure == "short_bellows")
      s.wall = fmt::format("healthy_mesh_{}", healthy_++ % 4);
    suite_.specimens.push_back(s);
  }

  Suite suite() {
    number_suite(suite_);
    return suite_;
  }

private:
  Suite suite_;
  int count_ = 0, healthy_ = 0;
};

} // namespace

Suite plan_mounted(std::uint64_t seed) {
  MountedPlanner plan(seed);
  const std::vector<std::string> structures{"short_bellows", "bolted_lap"};
  for (int i = 0; i < 27; ++i) plan.add(structures[i % 3 == 2], "none", "none", -1, {});
  for (const std::string& name : effect_names())
    for (const std::string& structure : structures)
      for (int strength = 1; strength < 3; ++strength)
        if (auto effects = graded(structure, name, strength, strength); !effects.empty())
          plan.add(structure, "effect", name, strength, std::move(effects));
  for (const char* cls : {"clearance", "hardening"})
    for (const std::string& structure : structures)
      plan.add(structure, "stranger", cls, 2, {stranger(structure, cls, 2)});
  for (const char* cls : {"rubber", "rocking_table", "coupling_spring"})
    plan.add("short_bellows", "stranger", cls, 1, {stranger("short_bellows", cls, 1)});
  return plan.suite();
}

} // namespace sealed

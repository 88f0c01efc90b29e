#include "diagnose/effects/on_table.hpp"
#include "diagnose/effects/places.hpp"
#include "model/description/place_keys.hpp"

#include <algorithm>
#include <array>

namespace plica {
namespace {

constexpr double width = 1.5; // of the priors, on a log scale

// Under a cap that is held rigidly: springs, against one kind of motion or both.
void add_rigid_ends(std::vector<Hypothesis>& found, const Structure& s) {
  const double arm = s.length / 4, k = 10 * s.stiffness;
  constexpr double rigid = 1e5; // of the structure's own
  const double held = rigid * s.stiffness, held_turning = held * arm * arm;
  const EffectParameter translation{"k_translation", "N/m", {PriorKind::log_normal, k, width}},
      rotation{"k_rotation", "Nm/rad", {PriorKind::log_normal, k * arm * arm, width}};
  for (const HeldEnds& ends : held_ends(s, true)) {
    const auto add = [&](const char* way, const std::vector<EffectParameter>& parameters,
                         const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& springs) {
      found.push_back(
          {.effect = "boundary_compliance",
           .place = ends.place,
           .way = way,
           .parameters = parameters,
           .changes = {ground_springs(ends.nodes, 1, 0), ground_springs(ends.nodes, 0, 1)},
           .coefficients = springs,
           .at_rig = false,
           .released = ends.nodes,
           .in_case = [place = ends.place, springs](const Case& now, const Eigen::VectorXd& v) {
             const Eigen::VectorXd both = springs(v);
             const double move = both[0], turn = both[1];
             CaseEdits edits;
             for (const Mount& m : mounts_at(now, place))
               edits.push_back(
                   {mount_key(m.cap),
                    "{stiffness: " + yaml_of({move, move, move, turn, turn, turn}) + "}"});
             return edits;
           }});
    };
    add("rotation", {rotation},
        [held](const Eigen::VectorXd& v) { return Eigen::Vector2d(held, v[0]); });
    add("translation", {translation},
        [held_turning](const Eigen::VectorXd& v) { return Eigen::Vector2d(v[0], held_turning); });
    add("", {translation, rotation}, [](const Eigen::VectorXd& v) { return v; });
  }
}

// Springs of a mount once more: all of them, or those against one kind of motion.
struct Motion {
  const char* name;
  int first, count; // of the rows of their law
};
constexpr std::array motions{Motion{"", 0, 6}, Motion{"translation", 0, 3},
                             Motion{"rotation", 3, 3}};

ModelChange once_more(const std::vector<int>& springs, const Motion& motion) {
  return {[springs, motion](Model& model) {
            for (int i : springs) {
              Matrix6& law = model.bushings[std::size_t(i)].bushing.law;
              law.diagonal().segment(motion.first, motion.count) *= 2;
            }
          },
          Follow::series};
}

bool stiff(const Model& model, const std::vector<int>& springs, const Motion& motion) {
  return std::any_of(springs.begin(), springs.end(), [&](int i) {
    return (model.bushings[std::size_t(i)]
                .bushing.law.diagonal()
                .segment(motion.first, motion.count)
                .array() > 0)
        .any();
  });
}

// Under a mount that is drawn with springs, whose law is diagonal: what they are in terms of these.
void add_springs(std::vector<Hypothesis>& found, const Structure& s) {
  const auto add = [&](const std::string& place, const std::vector<int>& springs) {
    const bool both =
        stiff(s.built.model, springs, motions[1]) && stiff(s.built.model, springs, motions[2]);
    for (const Motion& motion : motions) {
      if (motion.count < 6 && !both) continue;
      found.push_back(
          {.effect = "boundary_compliance",
           .place = place,
           .way = motion.name,
           .parameters = {{"ratio", "", {PriorKind::log_normal, 1, width}}},
           .changes = {once_more(springs, motion)},
           .coefficients = [](const Eigen::VectorXd& v) { return Eigen::VectorXd(v.array() - 1); },
           .at_rig = false,
           .in_case =
               [place, motion](const Case& now, const Eigen::VectorXd& v) {
                 CaseEdits edits;
                 for (const Mount& m : mounts_at(now, place)) {
                   Sextuple k = m.stiffness;
                   for (int i = 0; i < motion.count; ++i) k[std::size_t(motion.first + i)] *= v[0];
                   edits.push_back({mount_key(m.cap) + ".stiffness", yaml_of(k)});
                 }
                 return edits;
               }});
    }
  };
  std::vector<int> all;
  int mounts = 0;
  for (const Mount& m : s.data.mount) {
    const std::vector<int> own = springs_of(s.built.model, m);
    if (!stiff(s.built.model, own, motions[0])) continue;
    add(mount_key(m.cap), own);
    all.insert(all.end(), own.begin(), own.end());
    ++mounts;
  }
  if (mounts > 1) add(all_mounts, all);
}

std::vector<Hypothesis> boundary_compliance_hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  add_rigid_ends(found, s);
  add_springs(found, s);
  return found;
}

} // namespace

Effect boundary_compliance() {
  return {.name = "boundary_compliance",
          .plain = "a held end that gives way",
          .physics = "a held end gives way elastically",
          .signature = "the lowest modes fall most, the static stiffness of the rig stays",
          .look_alikes = {{"fixture_flexibility", "an accelerometer on the fixture"},
                          {"joint_stiffness", "the static stiffness of the rig"},
                          {"unweighed_mass", "an accelerometer on the held end"}},
          .needs = "a mount, rigid or with springs",
          .hypotheses = boundary_compliance_hypotheses};
}

} // namespace plica

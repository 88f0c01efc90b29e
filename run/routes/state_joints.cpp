#include "run/routes/state_joints.hpp"

#include "solve/state_elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace plica {
namespace {

// What the law asks beyond the linear model with its joints stuck.
JointLaw beyond_model(const BuiltJoint& joint) {
  JointLaw law = joint.law;
  if (!joint.in_model) law.stiffness -= law.stuck_stiffness();
  return law;
}

double of_sliders(const JointLaw& law) {
  double stiffness = 0;
  for (const JenkinsSlider& s : law.sliders) stiffness += s.stiffness;
  return stiffness;
}

// The whole force on first loading, and the share of the sliders' stiffness that has slipped.
StateJointResult described(const BuiltJoint& joint, double motion) {
  JointLaw whole = joint.law;
  if (joint.in_model) whole.stiffness = 0; // its curve is the whole
  double slipped = 0;
  for (const JenkinsSlider& s : whole.sliders)
    if (s.stiffness * std::abs(motion) > s.slip_force) slipped += s.stiffness;
  return {.joint = joint_name(joint),
          .angular = joint.dof >= 3,
          .motion = motion,
          .force = first_loading(whole, motion),
          .slipped = whole.sliders.empty() ? 0 : slipped / of_sliders(whole)};
}

} // namespace

void load_joints(BuiltCase& built) {
  std::vector<BushingElement>& all = built.model.bushings;
  std::map<std::pair<int, int>, int> between;
  for (BuiltJoint& j : built.joints) {
    const auto [known, is_new] = between.try_emplace({j.node1, j.node2}, int(all.size()));
    if (is_new)
      all.push_back({.node1 = j.node1 < 0 ? j.node2 : j.node1,
                     .node2 = j.node1 < 0 ? -1 : j.node2,
                     .bushing = {},
                     .component = j.component});
    j.spring = known->second;
    all[std::size_t(j.spring)].joints.push_back({j.dof, beyond_model(j)});
  }
}

void settle_joints(BuiltCase& built, StateResult& result) {
  constexpr double rounding = 1e-9; // of the largest motion: what symmetry leaves
  std::vector<double> motion;
  std::array<double, 2> largest{0, 0};
  for (const BuiltJoint& j : built.joints) {
    motion.push_back(
        state_motion(built.model, built.model.bushings[std::size_t(j.spring)]).value[j.dof]);
    double& most = largest[j.dof >= 3];
    most = std::max(most, std::abs(motion.back()));
  }
  for (const BuiltJoint& j : built.joints) {
    BushingElement& b = built.model.bushings[std::size_t(j.spring)];
    b.bushing.law.setZero();
    b.bushing.preload.setZero();
    b.joints.clear();
  }
  for (std::size_t k = 0; k < motion.size(); ++k) {
    BuiltJoint& j = built.joints[k];
    Bushing& spring = built.model.bushings[std::size_t(j.spring)].bushing;
    const JointLaw beyond = beyond_model(j);
    const double x = motion[k];
    const double slope = elastic_force(beyond, x, 0).by_motion + of_sliders(beyond);
    spring.law(j.dof, j.dof) += slope;
    spring.preload[j.dof] += first_loading(beyond, x) - slope * x;
    result.joints.push_back(described(j, x));
    if (std::abs(x) > rounding * largest[j.dof >= 3]) j.law.offset = x;
  }
}

BuiltCase slipping_in_state(BuiltCase settled) {
  for (BuiltJoint& j : settled.joints) {
    BushingElement& b = settled.model.bushings[std::size_t(j.spring)];
    const double stuck = of_sliders(j.law), x = state_motion(settled.model, b).value[j.dof];
    b.bushing.law(j.dof, j.dof) -= stuck;
    b.bushing.preload[j.dof] += stuck * x;
    j.law.stiffness -= elastic_force(j.law, 0, 0).by_motion;
  }
  return settled;
}

} // namespace plica

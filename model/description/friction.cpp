#include "model/description/friction.hpp"

#include <algorithm>

namespace plica {
namespace {

// A spring beyond a gap: straight up to it, then inclined, as far as anything moves.
std::vector<std::array<double, 2>> gap_curve(double gap, double stiffness) {
  const double far = 1e3 * gap;
  return {{-gap - far, -stiffness * far}, {-gap, 0}, {gap, 0}, {gap + far, stiffness * far}};
}

// Sum of two piecewise-linear curves.
std::vector<std::array<double, 2>> sum(const std::vector<std::array<double, 2>>& a,
                                       const std::vector<std::array<double, 2>>& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  std::vector<double> places;
  for (const auto* curve : {&a, &b})
    for (const auto& p : *curve) places.push_back(p[0]);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  const JointLaw first{.curve = a}, second{.curve = b};
  std::vector<std::array<double, 2>> total;
  total.reserve(places.size());
  for (double x : places)
    total.push_back({x, elastic_force(first, x, 0).force + elastic_force(second, x, 0).force});
  return total;
}

template <class Law>
void add(std::vector<DirectionalLaw>& all, const std::optional<Law>& law, const char* name,
         std::initializer_list<int> dofs) {
  if (!law) return;
  for (int dof : dofs) all.push_back({dof, name, joint_law(*law)});
}

} // namespace

template <bool angular> JointLaw joint_law(const FrictionLaw<angular>& law) {
  JointLaw joint{.cubic = law.cubic, .curve = law.curve};
  for (const SliderLaw<angular>& s : law.sliders)
    joint.sliders.push_back({s.stiffness, s.slip_force});
  if (law.iwan) {
    const auto& i = *law.iwan;
    for (const JenkinsSlider& s :
         sliders_of({i.stiffness, i.slip_force, i.chi, i.beta, i.smallest}, i.sliders))
      joint.sliders.push_back(s);
  }
  if (law.dry)
    joint.sliders.push_back({law.dry->stiffness, law.dry->coefficient * law.dry->normal_load *
                                                     (angular ? law.dry->radius : 1)});
  if (law.smoothed) joint.coulomb = {law.smoothed->slip_force, law.smoothed->velocity};
  if (law.clearance)
    joint.curve = sum(joint.curve, gap_curve(law.clearance->gap, law.clearance->stiffness));
  std::erase_if(joint.sliders, [](const JenkinsSlider& s) { return s.slip_force <= 0; });
  return joint;
}
template JointLaw joint_law(const FrictionLaw<false>&);
template JointLaw joint_law(const FrictionLaw<true>&);

std::vector<DirectionalLaw> directional_laws(const SlenderFriction& friction) {
  std::vector<DirectionalLaw> all;
  add(all, friction.axial, "axial", {1});
  add(all, friction.lateral, "lateral", {0, 2});
  add(all, friction.bending, "bending", {3, 5});
  add(all, friction.torsion, "torsion", {4});
  return all;
}

std::vector<DirectionalLaw> directional_laws(const JointFriction& friction) {
  std::vector<DirectionalLaw> all;
  add(all, friction.x, "x", {0});
  add(all, friction.y, "y", {1});
  add(all, friction.z, "z", {2});
  add(all, friction.rx, "rx", {3});
  add(all, friction.ry, "ry", {4});
  add(all, friction.rz, "rz", {5});
  return all;
}

} // namespace plica

#include "diagnose/effects/joint_groups.hpp"

#include "model/description/place_keys.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace plica {
namespace {

// Of the law of a spring: the pipe lies along y.
std::vector<int> rows_of(JointDirection motion) {
  static const std::array<std::vector<int>, 5> rows{{{0, 1, 2, 3, 4, 5}, {1}, {0, 2}, {3, 5}, {4}}};
  return rows[static_cast<std::size_t>(motion)];
}

// Stiffnesses of a beam that bear a motion; what it has across follows from bending.
std::vector<double*> numbers_of(BeamProperties& section, JointDirection motion) {
  switch (motion) {
  case JointDirection::all:
    return {&section.EA, &section.EI_y, &section.EI_z, &section.GJ};
  case JointDirection::axial:
    return {&section.EA};
  case JointDirection::lateral:
    return {};
  case JointDirection::bending:
    return {&section.EI_y, &section.EI_z};
  case JointDirection::torsion:
    return {&section.GJ};
  }
  return {};
}

// The largest in a translation; of a joint that turns alone, as a path at a lever.
double largest(const BushingElement& b, double lever) {
  const auto k = b.bushing.law.diagonal();
  const double moving = k.head<3>().maxCoeff();
  return moving > 0 ? moving : k.tail<3>().maxCoeff() / (lever * lever);
}

} // namespace

std::vector<JointGroup> joint_groups(const Structure& s) {
  const Model& model = s.built.model;
  std::vector<JointGroup> groups;
  const auto group_of = [&](int component) -> JointGroup& {
    const std::string& name = model.components[std::size_t(component)];
    for (JointGroup& g : groups)
      if (g.place == name) return g;
    groups.push_back({.place = name, .bushings = {}, .beams = {}});
    return groups.back();
  };
  std::set<std::string> lean; // where liners do
  for (const Part& part : s.data.parts) lean.insert(contact_place(part.name));
  std::set<int> fixtures;
  for (const auto& [cap, node] : s.built.fixture_nodes) fixtures.insert(node);
  for (std::size_t i = 0; i < model.bushings.size(); ++i) {
    if (fixtures.contains(model.bushings[i].node2)) continue; // for a sensor to sit on
    JointGroup& group = group_of(model.bushings[i].component);
    group.bushings.push_back(int(i));
    const double own = largest(model.bushings[i], lever_of(s));
    group.beside = lean.contains(group.place);
    group.stiffness = group.beside ? group.stiffness + own : std::max(group.stiffness, own);
  }
  for (JointGroup& g : groups) {
    g.mount = std::any_of(s.data.mount.begin(), s.data.mount.end(),
                          [&](const Mount& m) { return g.place == mount_key(m.cap); });
    if (!g.mount && !g.beside) g.stiffness /= double(g.bushings.size()); // in series
    g.rigid =
        std::find(s.rigid_clamps.begin(), s.rigid_clamps.end(), g.place) != s.rigid_clamps.end();
  }
  for (const Part& part : s.data.parts) {
    const auto* liner = std::get_if<Interlock>(&part.body);
    if (!liner) continue;
    const auto own = std::find(model.components.begin(), model.components.end(), part.name);
    if (own == model.components.end()) continue;
    JointGroup group{.place = part.name, .bushings = {}, .beams = {}};
    for (std::size_t i = 0; i < model.beams.size(); ++i)
      if (model.beams[i].component == own - model.components.begin()) group.beams.push_back(int(i));
    group.present = liner->EA > 0;
    group.nodes = model.mesh.sets.at(part.name + ".all");
    group.radius = liner->radius;
    const double length =
        (model.mesh.nodes[group.nodes.back()] - model.mesh.nodes[group.nodes.front()]).norm();
    if (length > 0) group.stiffness = group.present ? liner->EA / length : s.stiffness;
    if (group.stiffness > 0) groups.push_back(group);
  }
  std::erase_if(groups, [](const JointGroup& g) { return !(g.stiffness > 0); });
  return groups;
}

BeamProperties tube_of(const Model& model, const JointGroup& group) {
  const auto& x = model.mesh.nodes;
  const double length = (x[group.nodes.back()] - x[group.nodes.front()]).norm();
  const double EA = group.stiffness * length, r2 = group.radius * group.radius;
  BeamProperties tube;
  tube.EA = EA;
  tube.EI_y = tube.EI_z = EA * r2 / 2;
  tube.GJ = EA * r2 / 2.6;
  return tube;
}

const char* way_of(JointDirection motion) {
  constexpr std::array names{"", "axial", "lateral", "bending", "torsion"};
  return names[static_cast<std::size_t>(motion)];
}

bool turns(JointDirection motion) {
  return motion == JointDirection::bending || motion == JointDirection::torsion;
}

double stiffness_in(const Model& model, const JointGroup& group, JointDirection motion) {
  double compliance = 0, together = 0;
  for (int i : group.bushings) {
    const Matrix6& law = model.bushings[std::size_t(i)].bushing.law;
    double k = 0;
    for (int row : rows_of(motion)) k = std::max(k, law(row, row));
    if (!law.isDiagonal() || !(k > 0)) return 0;
    compliance += 1 / k;
    together += k;
  }
  if (group.beside) return together;
  for (std::size_t n = 1; n < group.nodes.size() && motion != JointDirection::lateral; ++n) {
    const BeamProperties section = group.present && n <= group.beams.size()
                                       ? model.beams[std::size_t(group.beams[n - 1])].section
                                       : tube_of(model, group);
    const double length =
        (model.mesh.nodes[group.nodes[n]] - model.mesh.nodes[group.nodes[n - 1]]).norm();
    const double k = motion == JointDirection::bending   ? section.EI_y
                     : motion == JointDirection::torsion ? section.GJ
                                                         : section.EA;
    if (!(k > 0)) return 0;
    compliance += length / k;
  }
  return compliance > 0 ? 1 / compliance : 0;
}

std::vector<std::pair<JointDirection, double>> motions_of(const Model& model,
                                                          const JointGroup& group) {
  std::vector<std::pair<JointDirection, double>> found;
  for (JointDirection motion : {JointDirection::axial, JointDirection::lateral,
                                JointDirection::bending, JointDirection::torsion})
    if (const double k = stiffness_in(model, group, motion); k > 0) found.emplace_back(motion, k);
  if (found.size() < 2) found.clear();
  return found;
}

double lever_of(const Structure& s) {
  return s.length / 4;
}

Prior ratio_prior(const Structure& s, double stiffness, JointDirection motion) {
  const double beside = s.stiffness * (turns(motion) ? lever_of(s) * lever_of(s) : 1);
  constexpr double share = 0.1; // of the structure's compliance
  const double centre = 1 / (1 + share * stiffness / beside);
  return {PriorKind::log_normal, centre, centre > 0.5 ? 1 : 1.5};
}

void scale_group(Model& model, const JointGroup& group, double factor, JointDirection motion) {
  for (int i : group.bushings) {
    Matrix6& law = model.bushings[std::size_t(i)].bushing.law;
    if (motion == JointDirection::all)
      law *= factor;
    else
      for (int row : rows_of(motion)) law(row, row) *= factor;
  }
  if (group.present) {
    for (int i : group.beams)
      for (double* number : numbers_of(model.beams[std::size_t(i)].section, motion))
        *number *= factor;
    return;
  }
  const BeamProperties tube = tube_of(model, group);
  BeamProperties own = tube;
  for (double* number : numbers_of(own, JointDirection::all)) *number = 0;
  BeamProperties given = tube;
  const std::vector<double*> from = numbers_of(given, motion), to = numbers_of(own, motion);
  for (std::size_t n = 0; n < to.size(); ++n) *to[n] = factor * *from[n];
  for (std::size_t i = 1; i < group.nodes.size(); ++i)
    model.beams.push_back({.node1 = group.nodes[i - 1], .node2 = group.nodes[i], .section = own});
}

ModelChange added_group(const JointGroup& group, JointDirection motion, double share) {
  if (!group.rigid)
    return {
        [group, motion](Model& model) { scale_group(model, group, group.present ? 2 : 1, motion); },
        Follow::series};
  return {[group, motion, share](Model& model) {
            for (int i : group.bushings) {
              BushingElement beside = model.bushings[std::size_t(i)];
              const Matrix6 whole = std::exchange(beside.bushing.law, Matrix6::Zero());
              for (int row : rows_of(motion))
                beside.bushing.law(row, row) = share * whole(row, row);
              model.bushings.push_back(beside);
            }
          },
          Follow::series};
}

} // namespace plica

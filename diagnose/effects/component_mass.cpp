#include "diagnose/effects/places.hpp"
#include "model/description/place_keys.hpp"

#include <algorithm>

namespace plica {
namespace {

// Multiplies some of the rigid bodies of the model.
ModelChange doubled(std::vector<int> masses) {
  return {[masses = std::move(masses)](Model& model) {
            for (int i : masses) {
              model.masses[std::size_t(i)].body.mass *= 2;
              model.masses[std::size_t(i)].body.inertia *= 2;
            }
          },
          Follow::series};
}

std::vector<int> masses_on(const Model& model, const std::vector<int>& nodes,
                           const std::function<bool(double)>& is_own) {
  std::vector<int> found;
  for (std::size_t i = 0; i < model.masses.size(); ++i)
    if (std::find(nodes.begin(), nodes.end(), model.masses[i].node) != nodes.end() &&
        is_own(model.masses[i].body.mass))
      found.push_back(int(i));
  return found;
}

void scale_body(CaseEdits& edits, const std::string& path, double mass, Sextuple inertia,
                double factor) {
  scale(edits, path + ".mass", mass, factor);
  if (inertia == Sextuple{}) return;
  for (double& x : inertia) x *= factor;
  edits.push_back({path + ".inertia", yaml_of(inertia)});
}

// "caps.left" or the name of a part, with so many times its mass.
CaseEdits with_mass(const Case& now, const std::string& place, double factor) {
  CaseEdits edits;
  if (is_at_cap(place)) {
    const Cap& cap = *cap_named(now, cap_of(place));
    scale_body(edits, place, cap.mass, cap.inertia, factor);
    return edits;
  }
  const Part& part = *part_named(now, place);
  if (const auto* body = std::get_if<PointMass>(&part.body))
    scale_body(edits, part_key(place), body->mass, body->inertia, factor);
  if (const auto* liner = std::get_if<Interlock>(&part.body))
    scale(edits, part_key(place) + ".mass", liner->mass, factor);
  return edits;
}

// Caps, attached masses, interlocks: a ratio to the mass in the case. An attached mass may be
// missing altogether.
std::vector<Hypothesis> component_mass_hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  const Model& model = s.built.model;
  const auto add = [&](const std::string& place, std::vector<int> masses, const Prior& prior) {
    if (masses.empty()) return;
    found.push_back(
        {.effect = "component_mass",
         .place = place,
         .way = "",
         .parameters = {{"ratio", "", prior}},
         .changes = {doubled(std::move(masses))},
         .coefficients = [](const Eigen::VectorXd& v) { return Eigen::VectorXd(v.array() - 1); },
         .in_case = [place](const Case& now,
                            const Eigen::VectorXd& v) { return with_mass(now, place, v[0]); }});
  };
  constexpr Prior drawn{PriorKind::log_normal, 1, 0.25}, attached{PriorKind::uniform, 0, 2};
  for (const Cap& cap : s.data.caps)
    if (cap.mass > 0)
      add(cap_key(cap.name),
          masses_on(model, {cap_node(s, cap.name)}, [&](double m) { return m == cap.mass; }),
          drawn);
  for (const Part& part : s.data.parts) {
    if (const auto* body = std::get_if<PointMass>(&part.body); body && body->mass > 0) {
      std::vector<int> own;
      for (std::size_t i = 0; i < model.masses.size(); ++i)
        if (model.masses[i].body.mass == body->mass &&
            (model.mesh.nodes[model.masses[i].node] -
             model.mesh.nodes[model.mesh.sets.at(body->at).front()])
                    .norm() < s.length / 2 &&
            (model.mesh.sets.at(body->at).size() > 1 ||
             model.masses[i].node == model.mesh.sets.at(body->at).front()))
          own.push_back(int(i));
      add(part.name, own, attached);
    }
    if (const auto* liner = std::get_if<Interlock>(&part.body); liner && liner->mass > 0)
      add(part.name,
          masses_on(model, model.mesh.sets.at(part.name + ".all"),
                    [&](double m) {
                      return std::none_of(s.data.caps.begin(), s.data.caps.end(),
                                          [&](const Cap& cap) { return cap.mass == m; });
                    }),
          drawn);
  }
  return found;
}

} // namespace

Effect component_mass() {
  return {.name = "component_mass",
          .plain = "a part whose mass is {ratio+} off the drawing",
          .physics = "a part is heavier or lighter than drawn, and the scale sees it",
          .signature = "mass and the modes that move the part",
          .look_alikes = {{"unweighed_mass", "weigh again"},
                          {"added_mass", "weigh with everything on it"}},
          .needs = "a cap, mass or interlock that has mass",
          .hypotheses = component_mass_hypotheses};
}

} // namespace plica

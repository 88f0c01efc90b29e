#include "model/shape/build_pipes.hpp"

#include "model/description/pipe_model.hpp"
#include "solve/couplings.hpp"

namespace plica {
namespace {

MassElement point(int node, double mass, double along = 0) {
  return {node, {.mass = mass, .offset = {0, along, 0}, .inertia = Eigen::Matrix3d::Zero()}};
}

MassElement ring(int node, double mass, double radius) {
  MassElement body = point(node, mass);
  const double J = mass * radius * radius / 2;
  body.body.inertia.diagonal() << J, 2 * J, J;
  return body;
}

} // namespace

AxisNodes add_pipe(Model& model, const EquivalentPipe& pipe, const Material& material,
                   int component) {
  const int first = add_node(model, {0, pipe.start, 0});
  int previous = first;
  const auto stretches = pipe_stretches(pipe, material);
  for (const PipeStretch& s : stretches) {
    for (int e = 1; e <= s.elements; ++e) {
      const int next = add_node(model, {0, s.from + (s.to - s.from) * e / s.elements, 0});
      for (const BeamProperties& layer : s.layers)
        model.beams.push_back({.node1 = previous,
                               .node2 = next,
                               .section = layer,
                               .up = {0, 0, 1},
                               .component = component});
      previous = next;
    }
    if (s.mass_at_end > 0) model.masses.push_back(point(previous, s.mass_at_end));
  }
  return {first, previous};
}

AxisNodes add_chain(Model& model, const ConnectorChain& chain, int component,
                    const std::string& name) {
  const double from = chain.start + chain.arms, between = chain.length - 2 * chain.arms;
  const int left = chain.arms > 0 ? add_node(model, {0, chain.start, 0}) : -1;
  const int first = add_node(model, {0, from, 0});
  for (int k = 1; k <= chain.count; ++k) {
    const int node = add_node(model, {0, from + between * k / chain.count, 0});
    const bool at_end = k == 1 || k == chain.count;
    BushingElement link{.node1 = node - 1, .node2 = node, .bushing = {}};
    link.component = component;
    link.bushing.law = connector_law(at_end && chain.end_spring ? *chain.end_spring : chain.spring);
    model.bushings.push_back(link);
  }
  const int last = first + chain.count;
  for (int node = first; node <= last; ++node) {
    const double share = node == first || node == last ? 0.5 : 1;
    model.masses.push_back(ring(node, share * chain.mass / chain.count, chain.radius));
  }
  if (chain.arms == 0) {
    if (chain.arm_mass > 0)
      for (int node : {first, last}) model.masses.push_back(point(node, chain.arm_mass));
    return {first, last};
  }
  const int right = add_node(model, {0, chain.start + chain.length, 0});
  const std::vector<int> all{0, 1, 2, 3, 4, 5};
  add_kinematic_coupling(model, left, {first}, all, "left arm of " + name);
  add_kinematic_coupling(model, right, {last}, all, "right arm of " + name);
  if (chain.arm_mass > 0) {
    model.masses.push_back(point(left, chain.arm_mass, chain.arms / 2));
    model.masses.push_back(point(right, chain.arm_mass, -chain.arms / 2));
  }
  return {left, right};
}

} // namespace plica

#include "diagnose/predict/rig_loss.hpp"
#include "diagnose/effects/beam_stiffness.hpp"
#include "model/description/place_keys.hpp"

#include <algorithm>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

ModelChange component_twice(int component) {
  return {[component](Model& model) {
            for (ShellProperties& s : model.shells)
              if (s.component == component) s.section.E *= 2;
            for (BeamElement& b : model.beams)
              if (b.component == component) scale_stiffness(b.section, 2);
            for (BushingElement& b : model.bushings)
              if (b.component == component) b.bushing.law *= 2;
          },
          Follow::nominal};
}

// A spring of 1 N/m (1 Nm/rad) in its place.
ModelChange unit_spring(const Model& model, const BuiltDamper& d) {
  const VectorXd force = unit_force(model, d.node1, d.node2, d.dof);
  OnMotion motion;
  for (const int node : {d.node1, d.node2})
    if (node >= 0) motion.nodes.push_back(node);
  motion.rows.resize(1, 6 * Eigen::Index(motion.nodes.size()));
  for (std::size_t k = 0; k < motion.nodes.size(); ++k)
    motion.rows.middleCols<6>(6 * Eigen::Index(k)) =
        force.segment<6>(6 * Eigen::Index(motion.nodes[k])).transpose();
  motion.stiffness = 1;
  return {.apply = {}, .follow = Follow::nominal, .on_motion = {motion}};
}

} // namespace

std::vector<RigLoss> rig_losses(const Damping& damping, const BuiltCase& built,
                                const ParametricModel& model) {
  std::vector<RigLoss> all;
  const std::vector<std::string>& components = built.model.components;
  for (const LossFactor& loss : damping.loss_factors) {
    const auto own = std::find(components.begin(), components.end(), loss.of);
    if (is_at_mount(loss.of) || own == components.end()) continue;
    all.push_back({model.prepare(component_twice(int(own - components.begin()))),
                   [eta = loss.value](double) { return eta; }});
  }
  for (const BuiltDamper& d : built.dampers)
    if (!is_at_mount(d.place))
      all.push_back({model.prepare(unit_spring(built.model, d)), [d](double omega) {
                       return added_stiffness(d.law, d.dof, d.stiffness, {0, omega}).imag();
                     }});
  std::erase_if(all, [](const RigLoss& l) { return l.stiffness.dofs.empty(); });
  return all;
}

} // namespace plica

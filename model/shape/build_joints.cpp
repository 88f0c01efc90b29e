#include "model/shape/build_joints.hpp"

#include "model/description/connector_curve.hpp"
#include "model/description/place_keys.hpp"
#include "solve/state_elements.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

namespace plica {

using Eigen::Vector3d;
using Eigen::VectorXd;

std::string joint_name(const BuiltJoint& joint) {
  return joint.place + " " + joint.motion +
         (joint.segment > 0 ? ", segment " + std::to_string(joint.segment) : "");
}

void add_joints(std::vector<BuiltJoint>& joints, const Connection& between,
                const std::vector<DirectionalLaw>& laws) {
  for (const DirectionalLaw& d : laws)
    joints.push_back({.place = between.place,
                      .motion = d.name,
                      .segment = between.segment,
                      .node1 = between.node1,
                      .node2 = between.node2,
                      .dof = d.dof,
                      .law = d.law,
                      .component = between.component});
}

void add_curves(std::vector<BuiltJoint>& joints, const Connection& between,
                const ConnectorSpring& spring) {
  const auto add = [&](const ForceCurve& curve, const char* motion,
                       std::initializer_list<int> dofs) {
    if (curve.empty()) return;
    for (int dof : dofs)
      joints.push_back({.place = between.place,
                        .motion = motion,
                        .segment = between.segment,
                        .node1 = between.node1,
                        .node2 = between.node2,
                        .dof = dof,
                        .law = {.stiffness = -stiffness_at_rest(curve), .curve = curve},
                        .in_model = true,
                        .component = between.component});
  };
  add(spring.axial_curve, "axial", {1});
  add(spring.transverse_curve, "transverse", {0, 2});
}

std::optional<std::vector<JointLaw>> laws_in(const Case& data,
                                             const std::vector<BuiltJoint>& joints) {
  std::map<std::string, std::vector<DirectionalLaw>> by_place;
  for (const Part& part : data.parts) {
    if (const auto* bellows = std::get_if<Bellows>(&part.body); bellows && bellows->wall.slip)
      return std::nullopt;
    if (const auto* chain = std::get_if<ConnectorChain>(&part.body); chain && chain->friction)
      by_place[part.name] = directional_laws(*chain->friction);
    const auto* liner = std::get_if<Interlock>(&part.body);
    if (liner && liner->contact && liner->contact->friction)
      by_place[contact_place(part.name)] = directional_laws(*liner->contact->friction);
    if (liner && liner->friction) {
      by_place[part.name] = directional_laws(*liner->friction);
      int segments = 1;
      for (const BuiltJoint& j : joints)
        if (j.place == part.name) segments = std::max(segments, j.segment);
      for (DirectionalLaw& d : by_place[part.name]) d.law = in_series(d.law, segments);
    }
  }
  for (const Cap& cap : data.caps) {
    if (cap.friction) by_place[cap_key(cap.name)] = directional_laws(*cap.friction);
    for (const SprungEnd& e : cap.ends)
      if (e.friction) by_place[sprung_end_key(cap.name, e.end)] = directional_laws(*e.friction);
  }
  for (const Mount& mount : data.mount)
    if (mount.friction) by_place[mount_key(mount.cap)] = directional_laws(*mount.friction);
  std::vector<JointLaw> laws;
  for (const BuiltJoint& j : joints) {
    laws.push_back(j.law); // of a tabulated connector
    if (j.in_model) continue;
    for (const DirectionalLaw& d : by_place[j.place])
      if (d.dof == j.dof && d.name == j.motion) {
        laws.back() = d.law;
        laws.back().stiffness -= elastic_force(d.law, 0, 0).by_motion;
      }
  }
  return laws;
}

void add_springs(Model& model, std::vector<BuiltJoint>& joints, JointState state) {
  // All directions between two nodes are one spring, which may then be the same all round.
  std::map<std::pair<int, int>, BushingElement> springs;
  for (BuiltJoint& j : joints) {
    if (j.in_model) continue;
    const double elastic = elastic_force(j.law, 0, 0).by_motion;
    BushingElement& spring = springs[{j.node1, j.node2}];
    spring.node1 = j.node1 < 0 ? j.node2 : j.node1;
    spring.node2 = j.node1 < 0 ? -1 : j.node2;
    spring.component = j.component;
    spring.bushing.law(j.dof, j.dof) +=
        state == JointState::stuck ? j.law.stuck_stiffness() : elastic;
    if (state == JointState::slipping) j.law.stiffness -= elastic;
  }
  for (const auto& [nodes, spring] : springs)
    if (!spring.bushing.law.isZero(0)) model.bushings.push_back(spring);
}

namespace {

// Of a spring at a state.
VectorXd unit_force(const Model& model, const BushingElement& spring, int dof) {
  VectorXd force = VectorXd::Zero(dof_count(model));
  const VectorXd row = state_motion(model, spring).by_nodes.row(dof);
  force.segment<6>(6 * Eigen::Index(spring.node1)) += row.head<6>();
  if (spring.node2 >= 0) force.segment<6>(6 * Eigen::Index(spring.node2)) += row.tail<6>();
  return force;
}

} // namespace

VectorXd unit_force(const Model& model, int node1, int node2, int dof) {
  if (model.rest) {
    BushingElement spring{
        .node1 = node1 < 0 ? node2 : node1, .node2 = node1 < 0 ? -1 : node2, .bushing = {}};
    if (node1 >= 0) spring.bushing.axes = model.rest->turned[std::size_t(node1)];
    return unit_force(model, spring, dof);
  }
  VectorXd force = VectorXd::Zero(dof_count(model));
  const auto& x = model.mesh.nodes;
  const Vector3d middle = node1 < 0 ? x[node2] : Vector3d((x[node1] + x[node2]) / 2);
  for (const auto& [node, sign] : {std::pair{node1, -1.}, std::pair{node2, 1.}}) {
    if (node < 0) continue;
    force[6 * node + dof] += sign;
    if (dof >= 3) continue;
    force.segment<3>(6 * node + 3) += sign * (middle - x[node]).cross(Vector3d::Unit(dof));
  }
  return force;
}

VectorXd unit_force(const Model& model, const BuiltJoint& joint) {
  if (joint.spring >= 0)
    return unit_force(model, model.bushings[std::size_t(joint.spring)], joint.dof);
  return unit_force(model, joint.node1, joint.node2, joint.dof);
}

Eigen::MatrixXd unit_forces(const Model& model, const std::vector<BuiltJoint>& joints) {
  Eigen::MatrixXd forces(dof_count(model), Eigen::Index(joints.size()));
  for (std::size_t j = 0; j < joints.size(); ++j)
    forces.col(Eigen::Index(j)) = unit_force(model, joints[j]);
  return forces;
}

} // namespace plica

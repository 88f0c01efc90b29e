// Joints with friction or nonlinear springs in a built case: between which nodes, in which
// direction, by which law.
#pragma once

#include "model/description/case.hpp"
#include "solve/model.hpp"

namespace plica {

enum class JointState { stuck, slipping };

struct BuiltJoint {
  std::string place;        // part, cap or mount: "interlock", "caps.clamp"
  std::string motion;       // "axial", "lateral", ... or "x" .. "rz"
  int segment = 0;          // from 1; 0 = there is but one
  int node1 = 0, node2 = 0; // node1 = -1: the ground
  int dof = 0;              // 0..5 along the axes of the part frame, in the middle of both nodes
  JointLaw law;
  bool in_model = false; // its slope at rest is in the linear model, and taken off the law
  int component = 0;     // whose strain energy it is
  int spring = -1;       // at a state: the bushing of the model that bears what its law asks there
};

// "interlock axial, segment 3"
std::string joint_name(const BuiltJoint& joint);

struct Connection {
  std::string place;
  int segment = 0, node1 = 0, node2 = 0, component = 0;
};
void add_joints(std::vector<BuiltJoint>& joints, const Connection& between,
                const std::vector<DirectionalLaw>& laws);
// The tabulated forces of a connector, beyond its stiffness at rest.
void add_curves(std::vector<BuiltJoint>& joints, const Connection& between,
                const ConnectorSpring& spring);

// The laws of these joints in another case that differs in friction alone, without building it.
// None where plies slip, whose laws come from the shells.
std::optional<std::vector<JointLaw>> laws_in(const Case& data,
                                             const std::vector<BuiltJoint>& joints);

// Springs in the model for what joints bear in small motion: stuck, with all their sliders;
// slipping, with their nonlinear springs alone, which then have that slope taken off.
void add_springs(Model& model, std::vector<BuiltJoint>& joints, JointState state);

// A spring of a mount or of a joint between ends whose damping the case states.
struct BuiltDamper {
  std::string place;        // "mount.engine", "caps.clamp"
  int node1 = 0, node2 = 0; // node1 = -1: the ground
  int dof = 0;
  double stiffness = 0; // of the spring, in the model
  SpringDamping law;
};

// Forces over all DOFs of a unit force along `dof` between the nodes (node1 = -1: the ground), in
// the middle of both; by them the motion of node2 against node1 is f' u. At a state the direction
// has turned with node1.
Eigen::VectorXd unit_force(const Model& model, int node1, int node2, int dof);
// Forces over all DOFs of a unit force in the joint; by them its motion is f' u.
Eigen::VectorXd unit_force(const Model& model, const BuiltJoint& joint);
Eigen::MatrixXd unit_forces(const Model& model,
                            const std::vector<BuiltJoint>& joints); // a column each

} // namespace plica

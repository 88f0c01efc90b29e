// What is solved: nodes, elements with their sections, and linear constraints between DOFs.
//
// Six DOFs per node, ux uy uz rx ry rz in global axes; DOF d of node n has the number 6 n + d.
#pragma once

#include "elements/beam_timoshenko.hpp"
#include "elements/bushing.hpp"
#include "elements/element_state.hpp"
#include "elements/joint_law.hpp"
#include "elements/rigid_mass.hpp"
#include "elements/shell_mitc3.hpp"
#include "elements/shell_mitc4.hpp"
#include "mesh/mesh.hpp"

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace plica {

struct ShellProperties {
  ShellSection section;
  MembraneStrain membrane = MembraneStrain::displacement; // of quads
  int component = 0;   // index into Model::components, here and below
  double pressure = 0; // at a state: Pa, against the wall along its directors
};

struct BeamElement {
  int node1 = 0, node2 = 0;
  BeamProperties section;
  Eigen::Vector3d up{0, 0, 1};
  Eigen::Vector3d offset1{0, 0, 0}, offset2{0, 0, 0};
  int component = 0;
};

struct MassElement {
  int node = 0;
  RigidMass body;
};

// What a spring bears beyond its law in one of its directions, on first loading.
struct SpringJoint {
  int dof = 0; // 0..5 along its axes
  JointLaw law;
};

struct BushingElement {
  int node1 = 0, node2 = -1; // node2 = -1: to the ground
  Bushing bushing;
  int component = 0;
  std::vector<SpringJoint> joints = {}; // on the way into a state
  // At a state: how the ground has moved.
  Eigen::Vector3d ground_shift{0, 0, 0};
  Eigen::Matrix3d ground_turn = Eigen::Matrix3d::Identity();
};

// The gas inside a part presses on a cap: area vector of the end it closes, out of the part, m2,
// about the node of the cap. Only at a state.
struct PressedEnd {
  int node = 0;
  Eigen::Vector3d area{0, 0, 0};
  double pressure = 0; // Pa
};

// Any element given by its matrices: a superelement. DOFs: the six of each node, in order.
struct MatrixElement {
  std::vector<int> nodes;
  Eigen::MatrixXd K, M;
  int component = 0;
};

// u(node, dof) = sum of factor * u(term); no terms: held at zero.
struct ConstraintTerm {
  int node = 0, dof = 0;
  double factor = 0;
};
struct Constraint {
  int node = 0, dof = 0;
  std::vector<ConstraintTerm> terms;
  std::string origin;         // who asked for it, for messages: "spider of cap left"
  std::string key = {};       // where a case asks for it: "caps.left.of"
  bool supports_deck = false; // a deck holds its DOF
};

// What a model at a state was at rest, node by node. Everything else of that model is as it is now:
// places, directors, arms, axes, couplings.
struct Rest {
  std::vector<Eigen::Vector3d> nodes;
  std::vector<Eigen::Matrix3d> turned;     // rotation since
  StiffnessPart part = StiffnessPart::all; // that its elements have
};

struct Model {
  std::vector<std::string> components; // names; every elastic element belongs to one
  Mesh mesh;
  std::vector<ShellProperties> shells; // index = section of quads and triangles
  std::vector<BeamElement> beams;
  std::vector<MassElement> masses;
  std::vector<BushingElement> bushings;
  std::vector<MatrixElement> matrices;
  std::vector<PressedEnd> pressed_ends;
  std::set<int> scalar_nodes; // their six DOFs are coordinates without place or direction
  std::vector<Constraint> constraints;
  std::shared_ptr<const Rest> rest = {}; // none: it is at rest, and without stress
};

int add_node(Model& model, const Eigen::Vector3d& position);
int dof_count(const Model& model);
int element_count(const Model& model);
ShellGeometry shell_geometry(const Mesh& mesh, const ShellQuad& quad);
TriangleGeometry shell_geometry(const Mesh& mesh, const ShellTriangle& triangle);
// Of the mass: areas at rest, directors as they are now.
ShellGeometry mass_geometry(const Model& model, const ShellQuad& quad);
TriangleGeometry mass_geometry(const Model& model, const ShellTriangle& triangle);
BeamGeometry beam_geometry(const Mesh& mesh, const BeamElement& beam);
BeamGeometry beam_at_rest(const Model& model, const BeamElement& beam); // of a model at a state
Eigen::MatrixXd bushing_matrix(const Mesh& mesh, const BushingElement& bushing); // its nodes' DOFs

} // namespace plica

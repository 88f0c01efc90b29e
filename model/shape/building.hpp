// A case while it is built, and what the pieces of the work share. They are called in the order of
// build(): parts, ends, liners, mount, sensors.
#pragma once

#include "model/shape/built_case.hpp"

#include <set>

namespace plica {

// A node of a place on shells that is to be tied to them.
struct PlacedOnWall {
  int node = 0, component = 0;
  std::string name; // "muffler.places.hanger"
};

struct Building {
  const Case& data;
  JointState state;
  const PlyLaws& plies;
  BuiltCase built = {};
  std::vector<std::string> rigid_sections = {}; // parts whose sections are

  std::vector<PlacedOnWall> wall_places = {};

  // New name under which elements store their strain energy.
  int component(const std::string& name);

  // Nodes of a set; `key` is where the case names it. InputError when the mesh has no such set.
  const std::vector<int>& set(const std::string& name, const std::string& key) const;

  // A node that follows others in all directions, such as the reference of an RBE3.
  bool follows_others(int node) const;
  // Those of the nodes that do, in one walk over the rows.
  std::set<int> followers_among(const std::vector<int>& nodes) const;

  bool is_on_wall(int node) const; // the node of a place
};

// Shells, beams, pipes, connectors, surfaces and decks; liners and masses come later.
void add_parts(Building& b);

// Caps with their springs, and masses on sets.
void add_caps(Building& b);
void add_mass(Building& b, const std::string& name, const PointMass& mass);

// The interlock, and the plies of a wall that stick to each other.
void add_liner(Building& b, const std::string& name, const Interlock& liner);
void add_ply_slip(Building& b, const std::string& name, const Bellows& bellows);

// Caps that are held or sprung, and sensors on their nodes.
void add_mount(Building& b);
void place_sensors(Building& b);

constexpr std::initializer_list<int> all_dofs{0, 1, 2, 3, 4, 5};
Eigen::Vector3d vector(const Triple& t);
RigidMass rigid_mass(double mass, const Sextuple& inertia, const Triple& offset);
Eigen::Vector3d centroid(const Mesh& mesh, const std::vector<int>& nodes);

} // namespace plica

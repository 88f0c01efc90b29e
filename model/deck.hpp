// A model that somebody else has written, as Abaqus and Nastran decks hold it: nodes, shells,
// beams, masses, springs, couplings, equations, what is held. In the units of the deck, which has
// none; seconds are assumed. Readers: io/decks.
#pragma once

#include "mesh/shell_surface.hpp"
#include "solve/model.hpp"

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace plica {

struct DeckShell {
  std::vector<int> nodes;        // three or four
  int section = 0;               // index into DeckModel::sections
  std::vector<double> thickness; // one per corner
  double offset = 0;             // nodes to the middle of the wall, along the normal
  std::string origin = {};       // for messages: "element 12 in line 34"
  std::vector<std::optional<Eigen::Vector3d>> normal; // given ones, one per corner or none at all
};

struct DeckCoupling {
  bool distributing = false; // or kinematic
  int reference = 0;
  std::vector<int> nodes;
  std::vector<double> weights; // distributing; empty = equal
  std::vector<int> dofs;       // 0..5; distributing: the first three, or else all
  std::string origin;          // for messages: "*COUPLING SPIDER"
};

struct DeckModel {
  std::vector<Eigen::Vector3d> nodes;
  std::vector<int> labels; // numbers of the nodes in the deck
  std::map<std::string, std::vector<int>> sets;
  std::vector<ShellSection> sections;
  std::vector<DeckShell> shells;
  std::vector<BeamElement> beams;
  std::vector<MassElement> masses;
  std::vector<BushingElement> bushings; // their law acts in the middle
  std::vector<MatrixElement> springs;   // between single DOFs, wherever their nodes are
  std::vector<DeckCoupling> couplings;
  std::vector<Constraint> equations;
  std::vector<Constraint> supports;
  std::set<std::string> files;       // that it was read from
  std::vector<std::string> left_out; // cards that are not followed: "model.inp:12: *DAMPING"
};

// Cards that are not known: an error each, or a list of what is left out.
enum class UnknownCards { error, list };

// Length and mass of one unit of the deck in m and kg; its forces follow with the second.
struct DeckUnits {
  double length = 1, mass = 1;
};

// What is done to a deck to make a part of it.
struct DeckPlacing {
  DeckUnits units = {};
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d move{0, 0, 0};
  bool held = true; // what the deck holds
  MembraneStrain membrane = MembraneStrain::incompatible;
};

// The deck as a model of one component. Normals that are not given are the mean of those of the
// facets that meet at less than 20 degrees, as in Abaqus. A wall beside its nodes has nodes of its
// own, which follow them rigidly. Nodes that nothing uses are left away; DOFs that no element
// and no constraint reaches are held. Throws std::runtime_error for what has no such model:
// a shell without area, DOFs one by one under a turn that is no multiple of 90 degrees.
Model place(const DeckModel& deck, const DeckPlacing& placing);

// No negative mass, and an inertia that a body can have.
bool is_body(const RigidMass& body);

// Turn of a placing: multiples of 90 degrees take DOFs to DOFs.
bool keeps_axes(const Eigen::Matrix3d& turn);

} // namespace plica

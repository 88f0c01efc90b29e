// Places of a case where effects may sit, as paths: "bellows.convolution[4]", "mount.left".
#pragma once

#include "diagnose/effects/effect.hpp"

namespace plica {

// Where a mass or a support may be put: nodes that share it, and the one a support touches.
struct Spot {
  std::string place;
  std::vector<int> nodes;
  int touched = 0;
  bool on_path = false; // of a beam, pipe or chain, where any place is looked at (beam_path.hpp)
  std::optional<Eigen::Vector3d> normal = {}; // of a plate, which gives way along it alone
};
// Numbers of 1..count that are looked at: all, or eight evenly spread, and up to `most` between.
std::vector<int> stations_of(int count, int most = 8);
// Sensors, and up to eight stations along every shell of revolution, pipe, chain and beam.
std::vector<Spot> spots(const Structure& s);
// Where something may touch or sit: these, of bellows up to sixteen crowns, so that of up to 32
// each is looked at or lies next to one that is, and a grid on every plate (plate_spots.hpp).
std::vector<Spot> contact_spots(const Structure& s);

// Springs that the structure's parts meet in: joints, connectors, the interlock.
struct JointGroup {
  std::string place;
  std::vector<int> bushings, beams; // of the model
  std::vector<int> nodes = {};      // of an interlock, along the axis
  double radius = 0;
  double stiffness = 0; // N/m, the largest of its translations
  bool present = true;  // false: the case gives it no stiffness
  bool mount = false;   // the springs of a mount
  bool rigid = false;   // the case draws it so: what its springs have says nothing
};
std::vector<JointGroup> joint_groups(const Structure& s);
// What stands in for an interlock without stiffness: a thin tube of its radius, massless, as its
// mass is there already.
BeamProperties tube_of(const Model& model, const JointGroup& group);

// What a joint gives way in: along the pipe, across it, about axes across it, about its axis.
enum class JointDirection { all, axial, lateral, bending, torsion };
const char* way_of(JointDirection motion); // "axial"; empty for all
bool turns(JointDirection motion);

// The stiffness of the group in a motion times a factor; an absent one gets the factor times
// `stiffness`.
void scale_group(Model& model, const JointGroup& group, double factor,
                 JointDirection motion = JointDirection::all);

// Adds the group once more; one that is absent, at its reference stiffness. Of one that is rigid a
// share, as springs beside it: a millionth has no digits left in the difference of two numbers that
// stand for rigid.
ModelChange added_group(const JointGroup& group, JointDirection motion = JointDirection::all,
                        double share = 1);

// N/m or Nm/rad of the group in one motion, from its one end to the other; 0: it has none, or its
// motions are coupled.
double stiffness_in(const Model& model, const JointGroup& group, JointDirection motion);

// Motions in which a group may give way alone, with its stiffness in each; empty where there are
// not several.
std::vector<std::pair<JointDirection, double>> motions_of(const Model& model,
                                                          const JointGroup& group);

// A quarter of the structure: where something turns, the lever at which that is a path.
double lever_of(const Structure& s);

// Of what a group has in one motion in terms of what the case says. A joint that is far stiffer
// than the structure beside it may give way by as much as that does, whatever large number stands
// for rigid.
Prior ratio_prior(const Structure& s, double stiffness, JointDirection motion);

// The wall of a bellows: its quads and, of each, the number of its convolution from 1, 0 = a cuff.
struct WallElements {
  std::string part;
  std::vector<int> quads;
  std::vector<int> convolution;
  int convolutions = 0;
  double root_radius = 0;
  std::vector<double> plies; // m
  double bond = 1;
};
std::vector<WallElements> walls(const Structure& s);

// Parts that share a cause: each part with shells or beams alone, then bellows that are drawn
// alike, "bellows_left and bellows_right".
struct PartGroup {
  std::string place;
  std::vector<std::string> parts; // at least one
  bool holds(const Model& model, int component) const;
};
std::vector<PartGroup> part_groups(const Structure& s);

// Reference node of a cap; -1 = none.
int cap_node(const Structure& s, const std::string& cap);
// What the table holds: a cap that is mounted rigidly, or the foot under the springs of a mount
// (build_on_table).
struct HeldEnds {
  std::string place;
  std::vector<int> nodes;
};
// Each, and all of them alike; `rigid`: without the feet of springs.
std::vector<HeldEnds> held_ends(const Structure& s, bool rigid = false);
// Springs to the table: N/m each way, Nm/rad about each axis.
ModelChange ground_springs(const std::vector<int>& nodes, double translation, double rotation);

Eigen::Vector3d quad_centre(const Model& model, int quad);
void add_point_mass(Model& model, int node, double mass);
void add_ground_spring(Model& model, int node, const std::array<double, 6>& stiffness);

} // namespace plica

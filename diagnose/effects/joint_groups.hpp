// Joints of a structure: what it gives way in, and how stiff it is there.
#pragma once

#include "diagnose/effects/effect.hpp"

namespace plica {

// Springs that the structure's parts meet in: joints, connectors, the interlock, and what that
// leans on along the wall.
struct JointGroup {
  std::string place;
  std::vector<int> bushings, beams; // of the model
  std::vector<int> nodes = {};      // of an interlock, along the axis
  double radius = 0;
  double stiffness = 0; // N/m, the largest of its translations
  bool present = true;  // false: the case gives it no stiffness
  bool mount = false;   // the springs of a mount
  bool rigid = false;   // the case draws it so: what its springs have says nothing
  bool beside = false;  // its springs bear beside each other, as those of a liner on a wall do
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

} // namespace plica

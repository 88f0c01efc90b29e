// Places of a case where effects may sit, as paths: "bellows.convolution[4]", "mount.left".
#pragma once

#include "diagnose/effects/effect.hpp"

namespace plica {

// y of the root circles of a bellows, from left to right.
std::vector<double> roots(const Mesh& mesh, const std::string& part);

// The wall of a bellows: its quads and, of each, the number of its convolution from 1, 0 = a cuff.
struct WallElements {
  std::string part;
  std::vector<int> quads;
  std::vector<int> convolution;
  std::vector<double> along; // of each, where it sits from the left end, 0, to the right, 1
  int convolutions = 0;
  double root_radius = 0;
  std::vector<double> plies; // m
  double bond = 1;
  std::optional<double> thickness_field = {}; // as in Wall
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

// Sensors of the case, then those of the test beside the part.
std::vector<std::string> sensor_names(const Structure& s);

// Reference node of a cap; -1 = none.
int cap_node(const Structure& s, const std::string& cap);
// What the table holds: a cap that is mounted rigidly, or the foot under the springs of a mount
// (build_on_table).
struct HeldEnds {
  std::string place;
  std::vector<int> nodes;
  // Of rigid mounts, where sensors sit on the fixture: its nodes, which stay on the table when the
  // ends give way and go with them when the fixture moves.
  std::vector<int> fixtures = {};
};
// Each, and all of them alike; `rigid`: without the feet of springs.
std::vector<HeldEnds> held_ends(const Structure& s, bool rigid = false);
// Springs to the table: N/m each way, Nm/rad about each axis.
ModelChange ground_springs(const std::vector<int>& nodes, double translation, double rotation);

Eigen::Vector3d quad_centre(const Model& model, int quad);
void add_point_mass(Model& model, int node, double mass);
void add_ground_spring(Model& model, int node, const std::array<double, 6>& stiffness);

} // namespace plica

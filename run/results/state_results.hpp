// The state around which a run was made: plain data, SI units (results.hpp).
#pragma once

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace plica {

struct StateIterationResult {
  double share = 0;    // of the loads
  double residual = 0; // beside the forces that act
  double step = 0;     // largest displacement of the increment, m
};

struct EndReaction {
  std::string cap;
  std::array<double, 3> force{}, moment{}; // of the part on what holds the cap, N, Nm
};

struct BucklingResult {
  double factor = 0;   // of the loads of the state
  double sideways = 0; // share of the motion of its nodes that is not along the axis
};

enum class SquirmKind { column, in_plane, elastic_column, elastic_in_plane, elastic_wall };
constexpr const char* word_of(SquirmKind kind) {
  constexpr std::array words{"column", "in plane", "elastic column", "elastic in plane",
                             "elastic wall"};
  return words.at(static_cast<std::size_t>(kind));
}
// Of the shells that were solved, not of a formula.
constexpr bool is_elastic(SquirmKind kind) {
  return kind >= SquirmKind::elastic_column;
}

// A limit of pressure by EJMA's formulas (model/description/ejma.hpp), or the lowest buckling load
// of the elastic shells of its kind, as a share of all loads of the state, beside the pressure.
struct SquirmResult {
  std::string bellows;
  SquirmKind kind = SquirmKind::column;
  double limit = 0;  // Pa, of a formula with the margin that it has
  double factor = 0; // limit / pressure
};

// Heat conducted along the wall of a part.
struct HeatResult {
  std::string part;
  double lowest = 0, highest = 0; // degC
  double across = 0;              // largest difference between the faces of the wall, K
  double through = 0;             // heat that goes in where it goes in, W
};

// A joint on first loading up to the state.
struct StateJointResult {
  std::string joint;
  bool angular = false;
  double motion = 0, force = 0; // m, N; angular: rad, Nm
  double slipped = 0;           // share of the stiffness of its friction that has slipped
};

// A beam tightened to its force.
struct BoltResult {
  std::string part;
  double force = 0;     // N
  double shortened = 0; // of its free length, m
};

struct StateResult {
  std::string name;                 // among the states of the case; empty: its one state
  std::vector<std::string> loads;   // in words
  std::vector<std::string> sources; // of the materials over temperature
  std::vector<HeatResult> heat;
  std::string route; // "rotational symmetry" or "full mesh"
  std::vector<StateIterationResult> iterations;
  int load_steps = 0;
  double largest_displacement = 0; // m
  double linear_error = 0;         // of the displacements of a linear solution, relative
  std::vector<EndReaction> reactions;
  std::vector<StateJointResult> joints;
  std::vector<BoltResult> bolts;
  std::vector<BucklingResult> buckling;
  bool buckling_looked_for = false;
  bool buckling_proved = false;
  std::string buckling_reason; // why not proved
  std::vector<SquirmResult> squirm;
  double turned_at = 0;         // share of the loads at which they first turned back; 0 = never
  Eigen::MatrixXd displacement; // nodes x 3, m
};

} // namespace plica

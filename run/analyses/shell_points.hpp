// Where the shells of a run are stressed, by name, and their stress in the directions of the wall.
//
// A convolution k of a bellows has the places "root k" and "crown k": what lies inside and outside
// of half the height between them; the last root closes the last convolution. Before and behind
// them are "left cuff" and "right cuff". Other shells are one place, their part.
#pragma once

#include "model/description/case.hpp"
#include "model/shape/built_case.hpp"
#include "run/results/life_results.hpp"
#include "solve/stress.hpp"

namespace plica {

struct StressPoint {
  int node = 0, place = 0;
  bool revolved = false;  // of a wall of revolution about y
  int ring = -1;          // of the mesh, where it is one's
  Eigen::Vector3d e1, e2; // in the wall: along the meridian and around it; else any two
  int wall = 0;           // in ShellPoints::plies
};

struct ShellPoints {
  std::vector<StressPlace> places;
  std::vector<StressPoint> points; // as in StressField
  // By wall: bending stress of each ply over that of the field, from inside; empty: the wall is
  // one.
  std::vector<std::vector<double>> plies;
};

ShellPoints shell_points(const Case& data, const BuiltCase& built, const StressField& field);

// Rows 6 point + 3 face + (11, 22, 12), Pa, of the columns of the field. Face: 0 below (inside of a
// bellows), 1 above.
Eigen::MatrixXd plane_stress(const ShellPoints& points, const Eigen::MatrixXd& shell);

// Of plies that slip and differ, the faces of the one that bends to most stress, in place of the
// equal plies that the field stands for.
void take_thickest_ply(const ShellPoints& points, Eigen::MatrixXd& plane);

// Principal stresses of (11, 22, 12), the larger first.
std::array<double, 2> principal(const Eigen::Vector3d& s);
double plane_von_mises(const Eigen::Vector3d& s);
// With the sign of the principal stress of larger magnitude.
double signed_von_mises(const Eigen::Vector3d& s);

} // namespace plica

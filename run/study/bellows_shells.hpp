// One bellows of a case by its shells alone: between two rigid ends, without liner, sensors and
// masses, as hand formulas see it.
#pragma once

#include "model/description/case.hpp"
#include "run/routes/route.hpp"

namespace plica {

// That bellows as a case of its own, both ends held; plies with friction slip freely.
Case bellows_alone(const Case& data, const Part& bellows);

// Meridional stress of the wall, Pa; each the largest magnitude over the wall, at its own place.
// Where the wall is not thin beside its arcs, its concave face bears more than bending alone.
struct MeridionalStress {
  double bending = 0; // half the difference of both faces
  double face = 0;    // of either face
};

// Movement of the right end against the held left one: along the axis with the end parallel; across
// it with the end parallel; a turn by a moment alone, all in one plane.
struct EndMovement {
  double axial = 0, lateral = 0, angular = 0; // m, m, rad
};

// Static shapes of the bellows under the three movements, as stress. Linear: a combination is the
// sum of the three fields.
class BellowsStatics {
public:
  // Throws InputError as build() does.
  BellowsStatics(const Case& alone, const StageListener& stage);

  const StaticStiffness& stiffness() const { return stiffness_; }
  // Of the signs of the movements the worst, of the wall between two places y along the axis.
  MeridionalStress stress(const EndMovement& movement,
                          const std::array<double, 2>& between = {-1e300, 1e300}) const;

private:
  StaticStiffness stiffness_;
  Eigen::VectorXd y_;             // of the points, m
  Eigen::MatrixXd below_, above_; // points x movements of 1 m, 1 m, 1 rad: meridional, Pa
};

// First modes with both ends held, Hz; none where it is not among the lowest forty.
struct FirstModes {
  std::optional<double> axial, transverse;
};
FirstModes first_modes(Case alone, const StageListener& stage);

} // namespace plica

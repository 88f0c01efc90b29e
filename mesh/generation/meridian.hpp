// The meridian of a shell of revolution: curves in the (y, r) plane, read from left to right.
//
// All lengths are of the mid-surface, in m. A convolution starts and ends at the same radius. The
// half of a U or omega convolution is a root arc of radius Rr, a straight wall of length L and a
// crown arc of radius Rc; the arcs turn through the angle phi. With q the pitch, h the height and
// a = Rr + Rc:
//
//   q/2   =  a sin(phi) + L cos(phi)
//   h - a = -a cos(phi) + L sin(phi)      so L^2 = (q/2)^2 + (h - a)^2 - a^2
//
// phi = 90 degrees gives parallel walls (U), more gives an omega.
#pragma once

#include "mesh/generation/curve_mesh.hpp"

#include <vector>

namespace plica {

struct MeridianDensity {
  int arc = 4;  // elements per quarter of an arc
  int wall = 5; // elements per wall
};

struct Convolution {
  double height = 0, pitch = 0, root_arc = 0, crown_arc = 0;
};

class Meridian {
public:
  Meridian(double y, double radius);

  // A straight stretch to `end_radius` (its own radius: a cylinder).
  void add_cuff(double length, double end_radius, int elements);
  // U or omega. Throws std::invalid_argument when the arcs do not fit.
  void add_convolution(const Convolution& shape, const MeridianDensity& density);
  // Welded disc: straight up to the crown and down again, a kink at the welds.
  void add_disc(double height, double pitch, const MeridianDensity& density);
  // One convolution through given points, the first at (0, radius), relative in y.
  void add_points(const std::vector<Eigen::Vector2d>& points, bool smooth,
                  const MeridianDensity& density);

  const std::vector<MeridianCurve>& curves() const { return curves_; }
  int convolutions() const { return convolutions_; }
  double y() const { return tip_.x(); }
  double radius() const { return tip_.y(); }

private:
  MeridianCurve& line_to(const Eigen::Vector2d& end, int elements);
  MeridianCurve& arc_to(const Eigen::Vector2d& end, const Eigen::Vector2d& centre, int elements);

  Eigen::Vector2d tip_; // (y, r) reached so far
  std::vector<MeridianCurve> curves_;
  int convolutions_ = 0;
};

// Angle phi and wall length L of a half convolution (formulas above).
// Throws std::invalid_argument when L^2 < 0.
struct HalfConvolution {
  double angle = 0, wall = 0;
};
HalfConvolution half_convolution(const Convolution& shape);

// Per curve its nodes, meshed by Gmsh, with the exact unit normal of that curve
// (to the left of the walking direction: outward on a cylinder), both ends included.
struct MeridianPoint {
  Eigen::Vector2d position, normal; // (y, r)
};
std::vector<std::vector<MeridianPoint>> mesh_meridian(const Meridian& meridian);

} // namespace plica

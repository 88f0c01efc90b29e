// A plate as a surface of places: what touches it or sits on it may do so anywhere.
//
// Between four nodes of its mesh, on up to eight cells either way, it moves along its normal by
// Adini's polynomials, whose edges are Hermite's cubics (Adini and Clough, Report to NSF G7337
// (1960)), and bilinearly in its own plane.
#pragma once

#include "diagnose/effects/anywhere.hpp"

#include <array>

namespace plica {

struct PlateGrid {
  std::string part;
  std::array<double, 2> length{};        // m, of edges 1 and 2
  std::array<std::vector<double>, 2> at; // m along either edge, of the lines of nodes across it
  std::vector<int> nodes;                // line by line along edge 1
  Plate plate;
  Eigen::Vector3d normal(double along, double across) const;
  std::vector<EffectParameter> place() const;     // m along edge 1 and edge 2
  int nearest(double along, double across) const; // node
  Triple point(double along, double across) const;
};

// Of every plate whose mesh is the grid that it asks for.
std::vector<PlateGrid> plate_grids(const Structure& s);

// Of a place on the plate, along a direction; none = along its normal.
MovingMotion motion_on(const Structure& s, const PlateGrid& grid,
                       const std::optional<Eigen::Vector3d>& direction, MotionTerm::Of of);

} // namespace plica

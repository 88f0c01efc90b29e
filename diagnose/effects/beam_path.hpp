// A beam, equivalent pipe or chain of connectors as a path of places: what sits on it may sit
// anywhere along.
//
// Between two nodes of the path a beam moves by Hermite's cubics across and straight along itself.
//
// A pipe is of beams. Of a chain the rings move rigidly with half of the link on either side, and a
// link gives way midway: the cubics leave either ring as its rigid half does, and round what is a
// step and a kink in the middle. Rigid arms move by them exactly.
#pragma once

#include "diagnose/effects/anywhere.hpp"
#include "diagnose/effects/spots.hpp"

namespace plica {

struct BeamPath {
  std::string part;
  std::vector<int> nodes; // some of the part's, its points among them
  std::vector<double> at; // of each: m along the part
  double length() const { return at.back(); }
  std::vector<EffectParameter> place() const; // m from its first node
};

// Of every part that is a beam.
std::vector<BeamPath> beam_paths(const Structure& s);
// Of these and of every equivalent pipe and chain of connectors.
std::vector<BeamPath> line_paths(const Structure& s);

// What lies on a path is one of the places along it, unless the case asks for places by name.
bool is_anywhere(const Structure& s, const Spot& spot);

// Of a place on the path, along a direction.
MovingMotion motion_along(const Structure& s, const BeamPath& path,
                          const Eigen::Vector3d& direction, MotionTerm::Of of);

} // namespace plica

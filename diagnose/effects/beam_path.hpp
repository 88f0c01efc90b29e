// A beam, equivalent pipe or chain of connectors as a path of places: what sits on it may sit
// anywhere along.
//
// Between two nodes of the path a beam moves by Hermite's cubics across and straight along itself,
// so that a spring or mass at a place s adds k h(s) h(s)', whose entries are polynomials of degree
// six: exactly the sum of those at seven places between the two nodes, with Lagrange's weights.
//
// A pipe is of beams. Of a chain the rings move rigidly with half of the link on either side, and a
// link gives way midway: the cubics leave either ring as its rigid half does, and round what is a
// step and a kink in the middle. Rigid arms move by them exactly.
#pragma once

#include "diagnose/effects/spots.hpp"

namespace plica {

struct BeamPath {
  std::string part;
  std::vector<int> nodes; // some of the part's, its points among them
  std::vector<double> at; // of each: m along the part
  double length() const { return at.back(); }
  std::size_t nearest(double s) const; // of the nodes
  // Of springs or masses at the samples, for one at s: they add up to it.
  Eigen::VectorXd weights(double s) const;
};

// What sits somewhere along: `size` and where, and what these are of the changes at the samples.
Hypothesis anywhere_along(const BeamPath& path, const EffectParameter& size,
                          std::vector<ModelChange> samples);

// Of every part that is a beam.
std::vector<BeamPath> beam_paths(const Structure& s);
// Of these and of every equivalent pipe and chain of connectors.
std::vector<BeamPath> line_paths(const Structure& s);

// What lies on a path is one of the places along it, unless the case asks for places by name.
bool is_along(const Structure& s, const Spot& spot);

// A change each for springs of 1 N/m along axes, or a mass of 1 kg, at the samples.
std::vector<ModelChange> support_along(const Structure& s, const BeamPath& path,
                                       const std::vector<Eigen::Vector3d>& axes);
std::vector<ModelChange> mass_along(const Structure& s, const BeamPath& path);

} // namespace plica

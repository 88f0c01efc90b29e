// Identified modes as entries of a test, in place of the signals they come from.
#pragma once

#include "lab/identification/identification.hpp"
#include "lab/measured/measured.hpp"

namespace plica {

// One identification with what its entries say of it.
struct IdentifiedRun {
  std::string title;
  Identification found;
  std::string state = {}; // of the entries it comes from
};

// Kind of motion by the axes of the part frame: axial or transverse where four fifths of the sum of
// squares lie along one, else other; torsion and shell modes look like one of these. Channels whose
// sensor is not known count by their own axis.
struct KindOfShape {
  MeasuredShape shape = MeasuredShape::other;
  std::optional<Axis> direction;
};
KindOfShape kind_of(const Eigen::VectorXcd& shape, const std::vector<std::string>& channels,
                    const std::vector<MeasuredSensor>& sensors);

// The test without its responses and signals, with the modes of the runs: kind, direction and order
// (of a kind and direction in a run, from the lowest), shape at two channels or more, and where a
// run has one reference that, with its level. Its own modes stay in states in which nothing was
// identified. Entries held out stay so where they are still there.
Measured identified_measured(const Measured& test, const std::vector<IdentifiedRun>& runs);

} // namespace plica

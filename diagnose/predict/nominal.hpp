// The nominal case in every state of the test, reduced and ready for changes.
//
// Hypotheses are tried on a coarse mesh of the bellows: what matters is how a reading changes with
// an effect. What the case's own mesh differs by is added as a constant difference of logarithms.
#pragma once

#include "diagnose/effects/effect.hpp"
#include "diagnose/predict/rig_loss.hpp"
#include "diagnose/readings/readings.hpp"
#include "solve/mode_labels.hpp"

#include <memory>

namespace plica {

struct NominalState {
  std::string name;
  Case data;
  BuiltCase built;                        // at rest
  std::unique_ptr<ParametricModel> model; // in the state of the case
  Eigen::VectorXd zeta;                   // of its modes, loss factors included
  Eigen::VectorXd viscous;                // the ratios among it, without loss factors and dampers
  std::vector<RigLoss> losses;            // these on a rig, where the test has one
  std::vector<ModeLabel> labels;
  std::vector<int> kinds; // of each label: a number for its shape and direction
  // The sensors of the case, then places where one might be put, massless and named by the place,
  // then the stations of a test: where it sees shapes and the case has no sensor, and what sits
  // beside the part.
  std::vector<BuiltSensor> observed;
  std::size_t stations = 0;
  std::vector<Eigen::Matrix3d> axes; // of each: rows are its own axes

  int number_of(const std::string& observed) const; // -1: none is called so
  std::vector<std::string> further_places() const;
};

struct Nominal {
  std::vector<NominalState> states; // the first: as it stands
  double stiffness = 0, mass = 0, length = 0, frequency = 0;
  bool coarse = false;                        // the mesh is coarser than that of the case
  std::vector<std::string> rigid_clamps = {}; // drawn so, here on springs (sprung_clamps.hpp)

  const NominalState& state(const std::string& name) const;
  Structure structure(const Measured& measured) const;
};

// Throws InputError as build() does, std::runtime_error for a structure that nothing holds.
Nominal nominal_of(const Case& data, const Measured& measured);

} // namespace plica

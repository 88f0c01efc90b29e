// The stress analyses of a run.
#pragma once

#include "run/analyses/response.hpp"

namespace plica {

// Shapes of the static stiffness, one column each, with what was applied: "1 mm axial".
struct StaticShapes {
  Eigen::MatrixXd u; // all DOFs x shapes
  std::vector<std::string> names;
};

// Name of the stress of mode i, from 0.
std::string mode_stress_name(int mode);

// Of a model at a state.
StressResult state_stress_result(const Model& model);

std::vector<StressResult> static_stresses(const StaticShapes& shapes, const Model& model);

// Of the modes, each scaled to a largest displacement of 1 mm; then, when there are excitations,
// harmonic at the frequencies asked for and RMS under their random inputs.
std::vector<StressResult> dynamic_stresses(const Stress& asked, const Response* response,
                                           const Model& model, const DampedModes& modes,
                                           const Excitations* excited);

} // namespace plica

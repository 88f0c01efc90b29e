// The stress analyses of a run: fields, and tables by place.
#pragma once

#include "run/analyses/response.hpp"
#include "solve/stress.hpp"

namespace plica {

// Stress of static shapes, one column each, with what was applied: "1 mm axial".
struct StaticStress {
  StressField field;
  std::vector<std::string> names;
  StressKind kind = StressKind::statics;
};

// Name of the stress of mode i, from 0.
std::string mode_stress_name(int mode);

// All add to results.stresses and results.stress_tables.

// Of a model at a state.
void add_state_stress(const Case& data, const BuiltCase& built, Results& results);

void add_static_stresses(StaticStress stress, const Case& data, const BuiltCase& built,
                         Results& results);

// Of the modes, each scaled to a largest displacement of 1 mm; then, when there are excitations,
// harmonic at the frequencies asked for and RMS under their random inputs.
void add_dynamic_stresses(const Case& data, const BuiltCase& built, const DampedModes& modes,
                          const Excitations* excited, Results& results);

} // namespace plica

// States of the specimen in measured.yaml, and what a baseline needs.
#pragma once

#include "io/input/field_reader.hpp"
#include "lab/measured/measured.hpp"

#include <string>

namespace plica {

// The key of a weighing as the file has it: "mass", or "mass[1]" of a list.
std::string weighing_key(const ReadLog& log, std::size_t i);

// Names that two states share, and entries of a state that is not there.
void check_states(const Measured& m, ReadLog& log);

// A change is explained from what was measured before and after it: entries that no baseline has.
void check_baselines(const Measured& m, ReadLog& log);

// What a diagnosis asks besides, which holds states against each other: that something was measured
// in each, and in a baseline every quantity that a later state has; else a damping would be held
// against what the case assumes. `log`: the name of the file and the lines of its keys. Throws
// InputError.
void check_states_of_diagnosis(const Measured& m, ReadLog log);

} // namespace plica

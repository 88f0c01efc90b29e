// Phases of ends that move, given without an amplitude.
#pragma once

#include "io/input/field_reader.hpp"

namespace plica {

// Adds a problem for each, at its line.
void refuse_phases_alone(ReadLog& log);

} // namespace plica

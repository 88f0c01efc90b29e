// Orders of measured modes: those that nobody stated, and those that cannot be.
#pragma once

#include "io/input/field_reader.hpp"
#include "lab/measured/measured.hpp"

namespace plica {

// Modes of shape `other` that a state and run has without a table and without any order are counted
// by their frequencies.
void count_modes_of_no_kind(Measured& m, const ReadLog& log);

// A mode of a higher order has the higher frequency, where both are of one shape and direction, in
// one state, seen and excited alike; modes of one order are one that was measured again, and lie
// near each other. Adds a problem, "modes[3].order", for each that does not.
void check_orders(const Measured& m, ReadLog& log);

} // namespace plica

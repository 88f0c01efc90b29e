// Orders of measured modes that cannot be.
#pragma once

#include "io/input/field_reader.hpp"
#include "lab/measured/measured.hpp"

namespace plica {

// A mode of a higher order has the higher frequency, where both are of one shape and direction, in
// one state, seen and excited alike. Adds a problem, "modes[3].order", for each that has not.
void check_orders(const Measured& m, ReadLog& log);

} // namespace plica

// results.json: the contract of the command line, for other programs.
//
// SI units, frequencies in Hz, memory in bytes, timing in s. A number that does not exist (a static
// stiffness not asked for, the harmonic of a part that is no body of revolution, anything not
// finite) is null, so that every key is always there. Doubles are written so that reading them
// gives the same bits. Bytes of a text that are no UTF-8 become U+FFFD.
#pragma once

#include "run/results/results.hpp"

#include <string>

namespace plica {

std::string results_json(const Results& results);

} // namespace plica

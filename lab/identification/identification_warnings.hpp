// What a user of identified modes must know of them.
#pragma once

#include "lab/identification/identification.hpp"

namespace plica {

// Few responses; few lines or a wide window in a bandwidth; a fast sweep; residues of more than one
// mode; shapes far from real; look-alikes that overlap; peaks without a mode; what is left
// unexplained. Warnings of the files come first.
std::vector<std::string> identification_warnings(const Identification& found);

} // namespace plica

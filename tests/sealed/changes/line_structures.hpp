#pragma once

#include "structures.hpp"

namespace sealed {

namespace steel {
constexpr double E = 210e9, nu = 0.3, rho = 7850;
}

void add_line_structures(std::vector<std::unique_ptr<ChangedStructure>>& all);
void add_plate(std::vector<std::unique_ptr<ChangedStructure>>& all);

} // namespace sealed

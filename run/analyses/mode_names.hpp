// Names for modes that would be called the same.
#pragma once

#include "run/results/results.hpp"

#include <functional>

namespace plica {

// u' K_c u by component (rows) of some modes by their places from 0 (columns).
using EnergyOfModes = std::function<Eigen::MatrixXd(const std::vector<int>& modes)>;

// Sets the place of modes of one shape, direction and order: the part that is strained most, or
// where that is one for all, which of them they are ("no. 2"; the two of a pair are one).
// `components`: the rows of the energy. Rigid modes keep their name.
void tell_apart(std::vector<ModeResult>& modes, const std::vector<std::string>& components,
                const EnergyOfModes& energy);

} // namespace plica

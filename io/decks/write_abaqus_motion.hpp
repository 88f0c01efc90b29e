// Steps of an Abaqus deck (write_abaqus.hpp) in which its base or its ends move.
#pragma once

#include "model/shape/build.hpp"

#include <functional>
#include <string>
#include <utility>

namespace plica {

// {node, dof} from 1, where a DOF of the model stands in the deck.
using DofInDeck = std::function<std::pair<int, int>(int node, int dof)>;

// The case must have a response; `modes`: as many are taken.
std::string abaqus_motion_steps(const Case& data, const BuiltCase& built, int modes,
                                const DofInDeck& place);

} // namespace plica

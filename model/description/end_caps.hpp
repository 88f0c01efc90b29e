// The two ends that a rig pulls at.
#pragma once

#include "model/description/case.hpp"

namespace plica {

// The caps of a case that has two, or of more the two that are mounted (a bolted lap between two
// held ends is a cap, too); empty where there are no such two.
std::vector<std::string> end_caps(const Case& data);

} // namespace plica

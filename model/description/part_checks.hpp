// Rules within the parts of a case: materials, profiles, shapes, inertia.
#pragma once

#include "model/description/check_log.hpp"

namespace plica {

void check_parts(const Case& data, CheckLog& log);

// The inertia tensor of a real body: each principal moment at most the sum of the other two.
void check_inertia(const std::string& key, const Sextuple& J, CheckLog& log);

} // namespace plica

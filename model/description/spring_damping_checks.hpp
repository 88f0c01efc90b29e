// Rules between the keys of damped springs.
#pragma once

#include "model/description/check_log.hpp"

namespace plica {

void check_spring_damping(const Case& data, CheckLog& log);

} // namespace plica

// Rules between the keys of a state and the rest of its case.
#pragma once

#include "model/description/check_log.hpp"

namespace plica {

void check_operating_state(const Case& data, CheckLog& log);

} // namespace plica

// Rules between the keys of the fatigue life.
#pragma once

#include "model/description/check_log.hpp"

namespace plica {

void check_life(const Case& data, CheckLog& log);

} // namespace plica

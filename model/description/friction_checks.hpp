// Rules of friction and of the levels at which a case is excited.
#pragma once

#include "model/description/check_log.hpp"

namespace plica {

void check_friction(const Case& data, CheckLog& log);

} // namespace plica

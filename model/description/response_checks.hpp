// Rules between the keys of damping, response and stress.
#pragma once

#include "model/description/check_log.hpp"

namespace plica {

void check_responses(const Case& data, CheckLog& log);

// A steady response needs a mount or supports.
void check_held(const std::string& key, const Case& data, CheckLog& log);

} // namespace plica

// Rules between the keys of transients and run-ups.
#pragma once

#include "model/description/check_log.hpp"

namespace plica {

void check_time_analyses(const Case& data, CheckLog& log);

// An amplitude of the excitation `of`: one of acceleration (base, ends) or force (forces).
void check_amplitude(const std::string& key, const std::string& of, bool acceleration, bool force,
                     const Case& data, CheckLog& log);

} // namespace plica

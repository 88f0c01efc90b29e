// Rules between the keys of a state and the rest of its case.
#pragma once

#include "model/description/check_log.hpp"

namespace plica {

void check_operating_state(const Case& data, CheckLog& log);

// Ends of bellows that no cap closes, "bellows.left": pressure has nothing to bear its thrust
// there.
std::vector<std::string> open_ends(const Case& data);

} // namespace plica

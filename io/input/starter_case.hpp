// The case file that `plica init` writes: a bellows with an interlock, every line explained.
#pragma once

#include <string>

namespace plica {

// `name`: of the case; letters, digits and underscores.
std::string starter_case(const std::string& name);

} // namespace plica

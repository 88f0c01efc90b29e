// The `fit` section of a case: texts with units turned into numbers, and its rules.
#pragma once

#include "model/description/check_log.hpp"

namespace plica {

// Fills the numbers of `data.fit` from its texts; what is wrong goes into the log. Bounds that are
// left out are the limits of the number's tolerance.
void resolve_fit(Case& data, CheckLog& log);

} // namespace plica

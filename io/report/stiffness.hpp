// Report of a dynamic stiffness: cuts over frequency, surfaces over frequency and amplitude, what
// it is beside the test.
#pragma once

#include "compare/compare_stiffness.hpp"

namespace plica {

// A whole page.
std::string stiffness_report(const EndDynamicStiffness& s,
                             const std::vector<StiffnessComparison>& compared);

} // namespace plica

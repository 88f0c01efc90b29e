// The text of a BREP file of OpenCASCADE held against its own counts, before OpenCASCADE reads it:
// that takes what is no number for zero, and crashes where a count is wrong.
//
// Refused are: a section that has more or fewer curves, surfaces or shapes than it says, or a curve
// or surface more or fewer numbers than its kind; what is no number where one belongs; a shape that
// no other is made of.
#pragma once

#include <string>

namespace plica {

// Throws std::runtime_error, "line 12: what is wrong".
void check_brep_text(const std::string& text);

} // namespace plica

// The text of a STEP file (ISO 10303-21) held against its own grammar and its own references,
// before OpenCASCADE reads it: that skips what it does not understand, and crashes on some of it.
//
// Refused are: a text that is no whole exchange structure; an entity number that is no 32-bit
// number, defined twice, or named and never defined; a face, loop, edge, vertex, shell or placed
// component that nothing refers to, so that it would be missing; splines whose numbers of knots,
// multiplicities and control points do not go together; shapes without a unit of length.
#pragma once

#include <string>

namespace plica {

// Throws std::runtime_error, "line 12: what is wrong".
void check_step_text(const std::string& text);

} // namespace plica

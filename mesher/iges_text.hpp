// The text of an IGES file (version 5.3) held against its own counts, before OpenCASCADE reads it.
//
// Refused are: lines that are not numbered on, section by section; a terminate line that counts
// other than the file; entities of the directory whose parameters do not follow it, and parameters
// that belong to none; a unit whose number and name differ.
#pragma once

#include <string>

namespace plica {

// Throws std::runtime_error, "line 12: what is wrong".
void check_iges_text(const std::string& text);

} // namespace plica

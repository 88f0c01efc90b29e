// Rules of a case that tie several keys together: references, names, geometry, what the analyses
// need. The bounds of single keys are in model/description/case_fields.hpp.
#pragma once

#include "model/description/case.hpp"
#include "words/input_error.hpp"

#include <string>
#include <vector>

namespace plica {

// All broken rules; file and line stay empty, the keys are paths of the case file. `bad` holds the
// keys already found wrong: what depends on them is not judged. `directory` is where the case file
// lies, for the file of measured data.
std::vector<InputProblem> check_case(const Case& data, const std::vector<std::string>& bad,
                                     const std::string& directory);

} // namespace plica

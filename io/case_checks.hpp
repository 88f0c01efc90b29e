// Rules of a case that tie several keys together: references, names, geometry, what the analyses
// need. The bounds of single keys are in model/case_fields.hpp.
#pragma once

#include "model/case.hpp"
#include "model/input_error.hpp"

#include <string>
#include <vector>

namespace plica {

// Names of the node sets the parts of the case have, e.g. "bellows.convolution[3]".
// Bellows: left, right, convolution[k], crown[k], root[k] (k from 1; root[n+1] ends the last one),
// cuff.left, cuff.right where there is one, all. Interlock: start, end, all. Plate: edge1..edge4,
// corner1..corner4, all. Beam: start, end, point[k] (k from 1), all.
std::vector<std::string> set_names(const Case& data);

// All broken rules; file and line stay empty, the keys are paths of the case file. `bad` holds the
// keys already found wrong: what depends on them is not judged. `directory` is where the case file
// lies, for the file of measured data.
std::vector<InputProblem> check_case(const Case& data, const std::vector<std::string>& bad,
                                     const std::string& directory);

// True if `key` is `ancestor` or lies below it.
bool is_below(const std::string& key, const std::string& ancestor);

} // namespace plica

// The part that the reader can turn, with its modes: a glTF of the thinned mesh, a morph target per
// mode, in the page for its script.
#pragma once

#include "run/results/results.hpp"

#include <string>

namespace plica {

// `drawing`: what stands there without scripts and on paper. Empty for a case without elements.
std::string part_viewer(const Results& results, const std::string& drawing);

} // namespace plica

// The part that the reader can turn, with its modes: a glTF of the thinned mesh, a morph target per
// mode, in the page for its script.
#pragma once

#include "run/results/results.hpp"

#include <optional>
#include <string>

namespace plica {

// `drawing`: what stands there without scripts and on paper. Empty for a case without elements.
// `mode`: which is shown first, still, by a drawing of its own without scripts; none: the part at
// rest. A mode beyond those that play has its drawing below the viewer.
std::string part_viewer(const Results& results, const std::string& drawing,
                        std::optional<std::size_t> mode = {});

} // namespace plica

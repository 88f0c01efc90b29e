// Data set 2414, results at nodes, in the form of a data set 55.
#pragma once

#include "io/universal/file.hpp"

#include <optional>
#include <string>

namespace plica {

// None for results of elements. Throws InputError for a set that is cut off or has other than
// numbers where numbers stand.
std::optional<UniversalShape> shape_of_results(const UniversalText& set, const std::string& file);

} // namespace plica

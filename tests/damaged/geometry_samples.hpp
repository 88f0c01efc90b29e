// Good files of geometry, CAD and triangles; see samples.hpp.
#pragma once

#include "tests/damaged/samples.hpp"

namespace plica::test {

std::vector<Sample> geometry_samples();

} // namespace plica::test

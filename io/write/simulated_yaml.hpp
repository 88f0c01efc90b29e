// A test as a measured.yaml: a run, so that `plica compare` takes simulation and test alike, or
// what `plica identify` found.
#pragma once

#include "lab/measured/measured.hpp"

#include <string>

namespace plica {

// All but time signals, single results (their scatter is the sigma) and of responses what only a
// lab says of them; reads back with read_measured() without loss.
std::string simulated_yaml(const Measured& measured);

} // namespace plica

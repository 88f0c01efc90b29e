// Reads a benchmark file (YAML), strictly. Throws InputError with all problems of the file.
#pragma once

#include "compare/benchmark.hpp"

namespace plica {

// Whether the file has a `benchmark` key in place of a `case`; false when it cannot be read.
bool is_benchmark(const std::string& path);

Benchmark read_benchmark(const std::string& path);

} // namespace plica

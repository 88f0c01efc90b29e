// Report of a benchmark: every table with the published values, ours and the test.
#pragma once

#include "compare/benchmark.hpp"

#include <string>

namespace plica {

std::string benchmark_html(const BenchmarkResult& result);

} // namespace plica

// A benchmark in words.
#pragma once

#include "compare/benchmark.hpp"

namespace plica {

// "131 to 163", "138", "-"
std::string test_text(const std::vector<double>& test);

// For the terminal.
std::string benchmark_text(const BenchmarkResult& result);

} // namespace plica

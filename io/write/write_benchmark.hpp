// What a benchmark leaves behind: benchmark.json, benchmark.csv, report.html.
#pragma once

#include "compare/benchmark.hpp"
#include "io/files/output_folder.hpp"

namespace plica {

std::vector<std::string> benchmark_files();
void write_benchmark(const BenchmarkResult& result, OutputFolder& out);

} // namespace plica

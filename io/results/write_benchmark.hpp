// What a benchmark leaves behind: benchmark.json, benchmark.csv, report.html.
#pragma once

#include "diagnose/benchmark.hpp"
#include "io/output/output_folder.hpp"

namespace plica {

std::vector<std::string> benchmark_files();
void write_benchmark(const BenchmarkResult& result, OutputFolder& out);

} // namespace plica

// Scoreboard: numbers of a published study beside those of cases run here and of the test.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plica {

// One way to run the case of a table: an alternative model, some numbers changed.
struct BenchmarkColumn {
  std::string name;
  std::string model; // empty = the parts of the case
  std::map<std::string, std::string> set;
};

struct BenchmarkRow {
  std::string label;
  std::string quantity; // headline key, quantity of the comparison, or path of a number
  std::string unit;
  double scale = 1;                // shown = SI * scale
  std::optional<double> published; // in the unit shown
  std::vector<double> test;        // one value, or lowest and highest; in the unit shown
  std::string only;                // column that it belongs to; empty = all
};

struct BenchmarkTable {
  std::string number, title;
  std::string case_file; // relative to the file of the benchmark
  std::vector<BenchmarkColumn> columns;
  std::vector<BenchmarkRow> rows;
  std::vector<std::string> remarks; // where ours differs, why
};

struct Benchmark {
  std::string name, title;
  std::string published; // head of the column, "thesis"
  std::vector<std::string> remarks;
  std::vector<BenchmarkTable> tables;
};

// Values of a table, rows x columns; none where the run has no such quantity.
using BenchmarkValues = std::vector<std::vector<std::optional<double>>>;

struct BenchmarkResult {
  Benchmark benchmark;
  std::vector<BenchmarkValues> values; // one per table
  int runs = 0;
};

} // namespace plica

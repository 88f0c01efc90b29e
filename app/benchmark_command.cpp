#include "app/commands.hpp"
#include "app/located.hpp"
#include "app/progress.hpp"
#include "diagnose/compare.hpp"
#include "io/files.hpp"
#include "io/input/benchmark_file.hpp"
#include "io/input/measured_file.hpp"
#include "io/results/write_benchmark.hpp"
#include "model/case_path.hpp"
#include "model/error_bars.hpp"
#include "model/run.hpp"
#include "solve/sparse_factor.hpp"

#include <fmt/core.h>
#include <tuple>

namespace plica {
namespace {

// One run of a case and what a row may ask of it.
struct BenchmarkRun {
  Case data;
  std::map<std::string, double> headline;
  std::vector<MeasuredComparison> comparison;
};

std::optional<double> value_of(BenchmarkRun& run, const std::string& quantity) {
  if (const auto found = run.headline.find(quantity); found != run.headline.end())
    return found->second;
  for (const MeasuredComparison& row : run.comparison)
    if (row.quantity == quantity) return row.computed;
  if (const double* number = number_at(run.data, quantity)) return *number;
  return std::nullopt;
}

// Every combination of case, model and changes is run once.
class Runs {
public:
  Runs(std::filesystem::path beside, Progress& progress)
      : beside_(std::move(beside)), progress_(progress) {}

  BenchmarkRun& of(const std::string& case_file, const BenchmarkColumn& column) {
    const auto [place, is_new] = done_.try_emplace(std::tuple(case_file, column.model, column.set));
    if (is_new) place->second = run_once((beside_ / case_file).string(), column);
    return place->second;
  }
  int count() const { return static_cast<int>(done_.size()); }

private:
  BenchmarkRun run_once(const std::string& path, const BenchmarkColumn& column) {
    const CaseFile file = read_case(path, column.model, column.set);
    progress_.title(file.data.name + ", " + column.name);
    std::optional<Measured> measured;
    if (!file.data.measured.empty())
      measured =
          read_measured((std::filesystem::path(path).parent_path() / file.data.measured).string());
    const Results results = located(file, [&] {
      return run(for_comparison(file.data), [&](const std::string& s) { progress_.stage(s); });
    });
    BenchmarkRun done{.data = file.data, .headline = headline(results), .comparison = {}};
    if (results.statics) done.headline["k_torsion"] = results.statics->k_torsion;
    if (measured) done.comparison = compare(results, *measured);
    return done;
  }

  std::filesystem::path beside_;
  Progress& progress_;
  std::map<std::tuple<std::string, std::string, std::map<std::string, std::string>>, BenchmarkRun>
      done_;
};

} // namespace

int benchmark_command(const RunOptions& options) {
  set_threads(options.threads);
  BenchmarkResult result{.benchmark = read_benchmark(options.case_path), .values = {}};
  make_folder(options.out);
  Progress progress(options.quiet);
  Runs runs(std::filesystem::path(options.case_path).parent_path(), progress);
  for (const BenchmarkTable& table : result.benchmark.tables) {
    BenchmarkValues values(table.rows.size(),
                           std::vector<std::optional<double>>(table.columns.size()));
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      BenchmarkRun& run = runs.of(table.case_file, table.columns[c]);
      for (std::size_t r = 0; r < table.rows.size(); ++r) {
        const BenchmarkRow& row = table.rows[r];
        if (!row.only.empty() && row.only != table.columns[c].name) continue;
        if (const auto value = value_of(run, row.quantity)) values[r][c] = *value * row.scale;
      }
    }
    result.values.push_back(std::move(values));
  }
  result.runs = runs.count();
  write_benchmark(result, options.out);
  progress.finish();
  if (!options.quiet)
    fmt::print("{}\nReport: {}\n", benchmark_text(result), (options.out / "report.html").string());
  return 0;
}

} // namespace plica

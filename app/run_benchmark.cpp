#include "app/chosen_case.hpp"
#include "app/finish.hpp"
#include "app/progress.hpp"
#include "app/run_options.hpp"
#include "app/terminal.hpp"
#include "compare/compare.hpp"
#include "io/input/benchmark_file.hpp"
#include "io/input/measured_file.hpp"
#include "io/tables/benchmark_words.hpp"
#include "io/write/write_benchmark.hpp"
#include "model/description/case_path.hpp"
#include "run/analyses/run.hpp"
#include "run/study/error_bars.hpp"
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

// Every combination of case, model and changes is read once, before the first is run, and run once.
class Runs {
public:
  Runs(const Benchmark& benchmark, const std::filesystem::path& beside) {
    for (const BenchmarkTable& table : benchmark.tables)
      for (const BenchmarkColumn& column : table.columns) {
        const auto [place, is_new] = inputs_.try_emplace(key_of(table.case_file, column));
        if (is_new) place->second = read((beside / table.case_file).string(), column);
      }
  }

  std::vector<std::filesystem::path> files() const {
    std::vector<std::filesystem::path> files;
    for (const auto& [key, input] : inputs_) {
      for (std::filesystem::path& file : files_of(input.file)) files.push_back(std::move(file));
      if (!input.test) continue;
      for (std::filesystem::path& file : files_of(*input.test)) files.push_back(std::move(file));
    }
    return files;
  }

  BenchmarkRun& of(const std::string& case_file, const BenchmarkColumn& column,
                   Progress& progress) {
    const auto [place, is_new] = done_.try_emplace(key_of(case_file, column));
    if (is_new) {
      const Input& input = inputs_.at(place->first);
      progress.title(input.file.data.name + ", " + column.name);
      place->second = run_once(input, progress);
    }
    return place->second;
  }
  int count() const { return static_cast<int>(done_.size()); }

private:
  using Key = std::tuple<std::string, std::string, std::map<std::string, std::string>>;
  using Input = TestedCase;

  static Key key_of(const std::string& case_file, const BenchmarkColumn& column) {
    return {case_file, column.model, column.set};
  }

  static Input read(const std::string& path, const BenchmarkColumn& column) {
    return with_test([&] { return read_case(path, column.model, column.set); },
                     {.path = path, .model = column.model, .state = {}, .set = column.set});
  }

  static BenchmarkRun run_once(const Input& input, Progress& progress) {
    const CaseFile& file = input.file;
    const Results results = with_doubts(file, [&] {
      return located(file, [&] {
        return run(for_comparison(file.data), [&](const std::string& s) { progress.stage(s); });
      });
    });
    BenchmarkRun done{.data = file.data, .headline = headline(results), .comparison = {}};
    if (results.statics) done.headline["k_torsion"] = results.statics->k_torsion;
    if (input.test) done.comparison = compare(results, input.test->data);
    return done;
  }

  std::map<Key, Input> inputs_;
  std::map<Key, BenchmarkRun> done_;
};

} // namespace

int run_benchmark(const RunOptions& options) {
  set_threads(options.threads);
  if (!options.chosen.set.empty())
    throw InputError({{.file = options.chosen.path,
                       .line = 0,
                       .key = "--set",
                       .wrong = "is of a case, and this file is a benchmark",
                       .allowed = "set of a column"}});
  BenchmarkResult result{.benchmark = read_benchmark(options.chosen.path), .values = {}};
  Runs runs(result.benchmark, std::filesystem::path(options.chosen.path).parent_path());
  std::vector<std::filesystem::path> inputs = runs.files();
  inputs.emplace_back(options.chosen.path);
  OutputFolder out(options.out.folder, {.command = "run",
                                        .inputs = std::move(inputs),
                                        .names = benchmark_files(),
                                        .json_only = options.out.json_only});
  Progress progress(options.out.quiet);
  for (const BenchmarkTable& table : result.benchmark.tables) {
    BenchmarkValues values(table.rows.size(),
                           std::vector<std::optional<double>>(table.columns.size()));
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      BenchmarkRun& run = runs.of(table.case_file, table.columns[c], progress);
      for (std::size_t r = 0; r < table.rows.size(); ++r) {
        const BenchmarkRow& row = table.rows[r];
        if (!row.only.empty() && row.only != table.columns[c].name) continue;
        if (const auto value = value_of(run, row.quantity)) values[r][c] = *value * row.scale;
      }
    }
    result.values.push_back(std::move(values));
  }
  result.runs = runs.count();
  write_benchmark(result, out);
  hand_over(out);
  progress.finish();
  if (!options.out.quiet)
    print(fmt::format("{}\nReport: {}\n", benchmark_text(result),
                      out.shown("report.html", "benchmark.json").string()));
  return 0;
}

} // namespace plica

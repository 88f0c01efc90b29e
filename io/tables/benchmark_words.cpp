#include "io/tables/benchmark_words.hpp"

#include "io/tables/text.hpp"
#include "io/tables/text_table.hpp"

#include <fmt/format.h>

namespace plica {
namespace {

constexpr int digits = 4;

std::string cell(const std::optional<double>& x) {
  return x ? significant(*x, digits) : "-";
}

// The number, and behind it how far it is from the published one, %.
std::string with_difference(const std::optional<double>& x, const std::optional<double>& from) {
  if (!x || !from || *from == 0) return cell(x);
  return fmt::format("{} ({})", cell(x), with_sign(100 * (*x / *from - 1), 1));
}

std::string table_text(const Benchmark& b, const BenchmarkTable& t, const BenchmarkValues& values) {
  TextRows rows{{"", "unit", "test", b.published}};
  for (const BenchmarkColumn& c : t.columns) rows[0].push_back(c.name);
  for (std::size_t r = 0; r < t.rows.size(); ++r) {
    const BenchmarkRow& row = t.rows[r];
    rows.push_back({row.label, row.unit, test_text(row.test), cell(row.published)});
    for (const auto& value : values[r])
      rows.back().push_back(with_difference(value, row.published));
  }
  std::string text = fmt::format("Table {}: {}\n", t.number, t.title) + text_table(rows, "<<>");
  for (const std::string& remark : t.remarks) text += "  * " + remark + "\n";
  return text + "\n";
}

} // namespace

std::string test_text(const std::vector<double>& test) {
  if (test.empty()) return "-";
  if (test.size() == 1 || test[0] == test[1]) return significant(test[0], digits);
  return significant(test[0], digits) + " to " + significant(test[1], digits);
}

std::string benchmark_text(const BenchmarkResult& result) {
  std::string text = fmt::format("{}, {} runs. In brackets: difference from the {} in %.\n\n",
                                 result.benchmark.title, result.runs, result.benchmark.published);
  for (std::size_t k = 0; k < result.values.size(); ++k)
    text += table_text(result.benchmark, result.benchmark.tables[k], result.values[k]);
  for (const std::string& remark : result.benchmark.remarks) text += "* " + remark + "\n";
  return text;
}

} // namespace plica

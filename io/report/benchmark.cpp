#include "io/report/benchmark.hpp"

#include "io/report/markup.hpp"
#include "io/report/page.hpp"
#include "io/tables/benchmark_words.hpp"

#include <fmt/format.h>

namespace plica {
namespace {

std::string table_html(const Benchmark& b, const BenchmarkTable& t, const BenchmarkValues& values) {
  std::vector<HtmlColumn> columns{
      {"", "", false}, {"unit", "", false}, {"test", ""}, {html_escape(b.published), ""}};
  for (const BenchmarkColumn& c : t.columns) {
    columns.push_back({html_escape(c.name), ""});
    columns.push_back({"", "%"});
  }
  std::vector<HtmlRow> rows;
  for (std::size_t r = 0; r < t.rows.size(); ++r) {
    const BenchmarkRow& row = t.rows[r];
    const std::string test = test_text(row.test);
    HtmlRow shown{{html_escape(row.label), html_escape(row.unit), test == "-" ? "–" : test,
                   row.published ? html_number(*row.published, 4) : "–"},
                  ""};
    for (const auto& value : values[r]) {
      shown.cells.push_back(value ? html_number(*value, 4) : "–");
      shown.cells.push_back(
          value && row.published ? html_signed(100 * (*value / *row.published - 1), 1) : "");
    }
    rows.push_back(std::move(shown));
  }
  return html_table("", columns, rows) + html_list(t.remarks);
}

} // namespace

std::string benchmark_html(const BenchmarkResult& result) {
  const Benchmark& b = result.benchmark;
  std::string sections;
  for (std::size_t k = 0; k < result.values.size(); ++k)
    sections += html_section(fmt::format("table-{}", k + 1),
                             html_escape("Table " + b.tables[k].number + ": " + b.tables[k].title),
                             table_html(b, b.tables[k], result.values[k]));
  sections += html_section("remarks", "Remarks", html_list(b.remarks));
  return report_page(
      b.title,
      fmt::format("{} runs. In %: difference from the {}.", result.runs, html_escape(b.published)),
      {}, sections);
}

} // namespace plica

#include "io/write/write_benchmark.hpp"

#include "io/files/json_text.hpp"
#include "io/report/benchmark.hpp"
#include "io/tables/csv.hpp"
#include "io/tables/text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plica {
namespace {

std::string benchmark_csv(const BenchmarkResult& result) {
  std::string text = "table,quantity,unit,test low,test high,published,column,ours\n";
  for (std::size_t k = 0; k < result.values.size(); ++k) {
    const BenchmarkTable& t = result.benchmark.tables[k];
    for (std::size_t r = 0; r < t.rows.size(); ++r)
      for (std::size_t c = 0; c < t.columns.size(); ++c) {
        const BenchmarkRow& row = t.rows[r];
        const auto number = [](const std::optional<double>& x) {
          return x ? fmt::format("{}", *x) : "";
        };
        text += fmt::format("{},{},{},{},{},{},{},{}\n", csv_cell(t.number), csv_cell(row.label),
                            csv_cell(row.unit), row.test.empty() ? "" : number(row.test.front()),
                            row.test.empty() ? "" : number(row.test.back()), number(row.published),
                            csv_cell(t.columns[c].name), number(result.values[k][r][c]));
      }
  }
  return text;
}

std::string benchmark_json(const BenchmarkResult& result) {
  const auto number = [](const std::optional<double>& x) { return x ? Json(*x) : Json(nullptr); };
  Json json{{"benchmark", result.benchmark.name},
            {"title", result.benchmark.title},
            {"runs", result.runs},
            {"remarks", result.benchmark.remarks}};
  json["tables"] = Json::array();
  for (std::size_t k = 0; k < result.values.size(); ++k) {
    const BenchmarkTable& t = result.benchmark.tables[k];
    Json rows = Json::array();
    for (std::size_t r = 0; r < t.rows.size(); ++r) {
      Json ours = Json::object();
      for (std::size_t c = 0; c < t.columns.size(); ++c)
        ours[t.columns[c].name] = number(result.values[k][r][c]);
      rows.push_back({{"label", t.rows[r].label},
                      {"quantity", t.rows[r].quantity},
                      {"unit", t.rows[r].unit},
                      {"test", t.rows[r].test},
                      {"published", number(t.rows[r].published)},
                      {"ours", ours}});
    }
    json["tables"].push_back({{"table", t.number},
                              {"title", t.title},
                              {"case", t.case_file},
                              {"rows", rows},
                              {"remarks", t.remarks}});
  }
  return json_text(json);
}

} // namespace

std::vector<std::string> benchmark_files() {
  return {"benchmark.csv", "report.html", "benchmark.json"};
}

void write_benchmark(const BenchmarkResult& result, OutputFolder& out) {
  out.add("benchmark.csv", benchmark_csv(result));
  out.add("report.html", benchmark_html(result));
  out.add("benchmark.json", benchmark_json(result));
}

} // namespace plica

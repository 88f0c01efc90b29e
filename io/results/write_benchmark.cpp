#include "io/results/write_benchmark.hpp"

#include "io/report/benchmark.hpp"
#include "io/results/csv.hpp"
#include "io/results/json_text.hpp"
#include "io/results/text.hpp"

#include <fmt/format.h>

#include <algorithm>

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

// Bytes are letters but for the continuation bytes of UTF-8.
std::size_t letters(const std::string& text) {
  return std::size_t(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

std::string padded(const std::string& text, std::size_t width, bool left) {
  const std::string space(width > letters(text) ? width - letters(text) : 0, ' ');
  return left ? text + space : space + text;
}

std::string table_text(const Benchmark& b, const BenchmarkTable& t, const BenchmarkValues& values) {
  std::vector<std::vector<std::string>> rows{{"", "unit", "test", b.published}};
  for (const BenchmarkColumn& c : t.columns) rows[0].push_back(c.name);
  for (std::size_t r = 0; r < t.rows.size(); ++r) {
    const BenchmarkRow& row = t.rows[r];
    rows.push_back({row.label, row.unit, test_text(row.test), cell(row.published)});
    for (const auto& value : values[r])
      rows.back().push_back(with_difference(value, row.published));
  }
  std::vector<std::size_t> widths(rows[0].size(), 0);
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], letters(row[i]));
  std::string text = fmt::format("Table {}: {}\n", t.number, t.title);
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += padded(row[i], widths[i], i < 2) + "  ";
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  for (const std::string& remark : t.remarks) text += "  * " + remark + "\n";
  return text + "\n";
}

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

std::vector<std::string> benchmark_files() {
  return {"benchmark.csv", "report.html", "benchmark.json"};
}

void write_benchmark(const BenchmarkResult& result, OutputFolder& out) {
  out.add("benchmark.csv", benchmark_csv(result));
  out.add("report.html", benchmark_html(result));
  out.add("benchmark.json", benchmark_json(result));
}

} // namespace plica

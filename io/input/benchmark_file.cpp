#include "io/input/benchmark_file.hpp"

#include "compare/benchmark_fields.hpp"
#include "io/input/field_reader.hpp"
#include "model/description/check_log.hpp"
#include "words/did_you_mean.hpp"

#include <algorithm>
#include <filesystem>

namespace plica {
namespace {

void check_table(const BenchmarkTable& t, const std::string& key,
                 const std::filesystem::path& beside, ReadLog& log) {
  std::error_code ignored;
  if (!t.case_file.empty() && !std::filesystem::is_regular_file(beside / t.case_file, ignored))
    log.add(key + ".case", "there is no file '" + shown(t.case_file) + "'",
            "give a path relative to this file");
  std::vector<std::string> columns;
  for (const BenchmarkColumn& c : t.columns) columns.push_back(c.name);
  for (std::size_t i = 0; i < t.rows.size(); ++i)
    if (const std::string& only = t.rows[i].only;
        !only.empty() && std::find(columns.begin(), columns.end(), only) == columns.end())
      log.add(item(key + ".rows", i) + ".only", "there is no column '" + shown(only) + "'",
              suggestion(only, columns));
}

} // namespace

bool is_benchmark(const std::string& path) {
  std::vector<InputProblem> problems;
  const YamlNode root = read_yaml(path, problems).root;
  return root.kind == YamlNode::Kind::map && root.find("benchmark");
}

Benchmark read_benchmark(const std::string& path) {
  ReadLog log{.file = path};
  const YamlNode root = read_yaml(path, log.problems).root;
  if (root.kind == YamlNode::Kind::null) throw InputError(std::move(log.problems));
  Benchmark data;
  FieldReader::read(root, "", data, log);
  for (std::size_t i = 0; i < data.tables.size(); ++i)
    check_table(data.tables[i], item("tables", i), std::filesystem::path(path).parent_path(), log);
  if (!log.problems.empty()) {
    sort_by_line(log.problems, log.file);
    throw InputError(std::move(log.problems));
  }
  return data;
}

} // namespace plica

#include "io/write/write_sweep.hpp"

#include "io/files/json_text.hpp"
#include "io/tables/csv.hpp"
#include "run/results/computed_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace plica {
namespace {

std::string name_of(const SweptColumn& column) {
  std::string name;
  for (const std::string& path : column.paths) name += (name.empty() ? "" : ",") + path;
  return name;
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

std::optional<double> value_of(const SweepRecord& record, const std::string& result) {
  for (const auto& [name, value] : record.values)
    if (name == result) return value;
  return std::nullopt;
}

} // namespace

SweepCounts counts_of(const SweepTable& table) {
  SweepCounts counts;
  for (const auto& row : table.rows)
    ++(!row ? counts.missing : row->failure.empty() ? counts.ok : counts.failed);
  return counts;
}

std::vector<std::string> results_of(const SweepTable& table) {
  if (!table.results.empty()) return table.results;
  std::vector<std::string> names;
  std::set<std::string> known;
  for (const auto& row : table.rows)
    if (row)
      for (const auto& [name, value] : row->values) known.insert(name);
  for (const char* usual : {"mass", "k_axial", "f_axial", "f_transverse", "f_torsion"})
    if (known.erase(usual) > 0) names.emplace_back(usual);
  names.insert(names.end(), known.begin(), known.end());
  return names;
}

std::string sweep_csv(const SweepTable& table) {
  const std::vector<std::string> results = results_of(table);
  std::string text = "variant";
  for (const SweptColumn& column : table.plan.columns)
    text += "," + csv_cell(with_unit(name_of(column), column.unit));
  for (const std::string& result : results)
    text += "," + csv_cell(with_unit(result, unit_of_result(result)));
  text += ",status,reason\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    text += std::to_string(i + 1);
    for (const SweptColumn& column : table.plan.columns)
      text += "," +
              (column.numbers.empty() ? csv_cell(column.texts[i]) : csv_number(column.numbers[i]));
    const auto& row = table.rows[i];
    for (const std::string& result : results)
      text += "," + csv_number(row ? value_of(*row, result) : std::nullopt);
    text += !row                   ? ",missing,not run yet"
            : row->failure.empty() ? ",ok,"
                                   : ",failed," + csv_cell(row->failure);
    text += '\n';
  }
  return text;
}

std::vector<std::string> sweep_files() {
  return {"sweep.csv", "sweep.h5", "sweep.json"};
}

void write_sweep(const SweepTable& table, OutputFolder& out) {
  const SweepCounts counts = counts_of(table);
  Json json{{"case", table.case_name},   {"variants", table.plan.variants},
            {"ok", counts.ok},           {"failed", counts.failed},
            {"missing", counts.missing}, {"columns", Json::array()},
            {"results", Json::array()}};
  for (const SweptColumn& column : table.plan.columns)
    json["columns"].push_back({{"paths", column.paths}, {"unit", column.unit}});
  for (const std::string& result : results_of(table))
    json["results"].push_back({{"name", result}, {"unit", unit_of_result(result)}});
  out.add("sweep.csv", sweep_csv(table));
  out.add_by("sweep.h5", [&](const auto& file) { write_sweep_hdf5(table, file); });
  out.add("sweep.json", json_text(json));
}

std::string sweep_text(const SweepTable& table, int shards) {
  const SweepCounts counts = counts_of(table);
  std::string text = fmt::format("{} variants, {} failed", table.rows.size(), counts.failed);
  if (counts.missing > 0) {
    std::set<int> holes;
    for (std::size_t i = 0; i < table.rows.size(); ++i)
      if (!table.rows[i]) holes.insert(static_cast<int>(i % std::size_t(shards)) + 1);
    text += fmt::format(", {} not run yet", counts.missing);
    if (shards > 1) {
      std::string names;
      for (const int shard : holes)
        names += (names.empty() ? "" : ", ") + std::to_string(shard) + "/" + std::to_string(shards);
      text += fmt::format(" (of shard{} {})", holes.size() > 1 ? "s" : "", names);
    }
    text += ": the same command runs them, without --shard all of them";
  }
  return text + "\n";
}

} // namespace plica

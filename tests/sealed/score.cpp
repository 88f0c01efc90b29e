// Prints confusion matrix, metrics with bounds and ablations; writes score.json.
#include "files.hpp"
#include "metrics.hpp"

#include <fmt/format.h>
#include <fstream>

namespace sealed {
namespace {

using nlohmann::json;

const std::vector<std::string> verdict_columns{"none",    "ambiguous", "unknown",
                                               "several", "mostly",    "missing"};

// Row: what was done to the specimen; column: the verdict, or the effect it identified.
json confusion_of(const std::vector<Scored>& all) {
  json matrix = json::object();
  for (const Scored& s : all) {
    const std::string row = s.kind == "pair" ? "pair" : s.cls;
    const std::string column =
        s.verdict == "identified" && !s.named.empty() ? s.named[0] : s.verdict;
    json& cell = matrix[row][column];
    cell = (cell.is_null() ? 0 : int(cell)) + 1;
  }
  return matrix;
}

void print_confusion(const json& matrix) {
  std::vector<std::string> columns = effect_names();
  columns.insert(columns.end(), verdict_columns.begin(), verdict_columns.end());
  fmt::print("Confusion (rows: truth, columns: verdict)\n");
  for (std::size_t c = 0; c < columns.size(); ++c) fmt::print("  {:2} {}\n", c + 1, columns[c]);
  fmt::print("{:26}", "");
  for (std::size_t c = 0; c < columns.size(); ++c) fmt::print("{:4}", c + 1);
  fmt::print("\n");
  for (const auto& [row, cells] : matrix.items()) {
    fmt::print("{:26}", row);
    for (const std::string& column : columns)
      fmt::print("{:>4}", cells.contains(column) ? std::to_string(int(cells[column])) : ".");
    fmt::print("\n");
  }
}

json as_json(const Metric& m) {
  json j{{"metric", m.number},
         {"name", m.name},
         {"accept", m.accept},
         {"at_most", m.at_most},
         {"cases", m.of}};
  if (m.known())
    j.update({{"value", m.value}, {"low", m.low}, {"high", m.high}, {"passes", m.passes()}});
  if (!m.note.empty()) j["note"] = m.note;
  return j;
}

void print(const Metric& m) {
  if (!m.known()) {
    fmt::print("{:3}  {:48} no cases {}\n", m.number, m.name, m.note);
    return;
  }
  const std::string bounds =
      m.low == 0 && m.high == 0 ? "" : fmt::format("[{:.3f}, {:.3f}]", m.low, m.high);
  fmt::print("{:3}  {:48} {:8.3f} {:17} n = {:3}  {} {:<5} {}\n", m.number, m.name, m.value, bounds,
             m.of, m.at_most ? "<=" : ">=", m.accept, m.passes() ? "good" : "MISSED");
  if (!m.note.empty()) fmt::print("     {}\n", m.note);
}

// An ablation hurts when some metric gets worse than with the whole method.
json ablation(const std::string& name, const std::vector<Metric>& whole,
              const std::vector<Metric>& without) {
  json worse = json::array();
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (!whole[i].known() || !without[i].known() || whole[i].number == 16) continue;
    const double change = without[i].value - whole[i].value;
    if (whole[i].at_most ? change > 0 : change < 0)
      worse.push_back(
          {{"name", whole[i].name}, {"with", whole[i].value}, {"without", without[i].value}});
  }
  fmt::print("without {}: {}\n", name, worse.empty() ? "nothing is worse" : "worse");
  for (const json& w : worse)
    fmt::print("     {:48} {:8.3f} -> {:.3f}\n", std::string(w["name"]), double(w["with"]),
               double(w["without"]));
  return {{"without", name}, {"hurts", !worse.empty()}, {"worse", worse}};
}

} // namespace

bool score_suite(const ScoreRequest& r) {
  const std::vector<Scored> all = read_verdicts(r.truth, r.out);
  const std::vector<Metric> metrics = metrics_of(all);
  const json confusion = confusion_of(all);
  print_confusion(confusion);
  bool good = true;
  json score{{"truth", fingerprint(r.truth)},
             {"cases", all.size()},
             {"confusion", confusion},
             {"metrics", json::array()},
             {"ablations", json::array()}};
  fmt::print("\n{}\n", std::string(score["truth"]));
  for (const Metric& m : metrics) {
    print(m);
    score["metrics"].push_back(as_json(m));
    if (m.number == 1 || m.number == 6 || m.number == 7) good = good && (!m.known() || m.passes());
  }
  bool all_hurt = true;
  for (const std::string& named : r.ablations) {
    const auto split = named.find('=');
    const auto without = metrics_of(read_verdicts(r.truth, named.substr(split + 1)));
    score["ablations"].push_back(ablation(named.substr(0, split), metrics, without));
    all_hurt = all_hurt && bool(score["ablations"].back()["hurts"]);
  }
  if (!r.ablations.empty()) fmt::print(" 15  every ablation hurts: {}\n", all_hurt ? "yes" : "NO");
  json cases = json::array();
  for (const Scored& s : all) {
    good = good && s.verdict != "missing";
    cases.push_back({{"id", s.id},
                     {"class", s.cls},
                     {"strength", s.truth["strength"]},
                     {"structure", s.truth["structure"]},
                     {"road", s.truth["road"]},
                     {"verdict", s.verdict},
                     {"named", s.named},
                     {"detectable", s.is_detectable}});
  }
  score["specimens"] = cases;
  std::ofstream(r.out / "score.json") << score.dump(1) << '\n';
  return good || !r.require;
}

} // namespace sealed

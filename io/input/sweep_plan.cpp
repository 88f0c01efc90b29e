#include "io/input/sweep_plan.hpp"

#include "io/lab_files/csv_table.hpp"
#include "model/description/case_path.hpp"
#include "model/description/check_log.hpp"
#include "run/study/design_of_experiments.hpp"
#include "words/short_text.hpp"
#include "words/units.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>

namespace plica {
namespace {

constexpr int most_variants = 1000000;

[[noreturn]] void refuse(const std::string& option, const std::string& wrong,
                         const std::string& allowed) {
  throw InputError({{.file = "", .line = 0, .key = option, .wrong = wrong, .allowed = allowed}});
}

// Cut at a letter that stands in no bracket.
std::vector<std::string> parts_of(const std::string& text, char cut) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : text) {
    depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
    if (c == cut && depth == 0)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

struct Varied {
  std::vector<std::string> paths;
  std::vector<std::string> list; // values; empty: a range
  double low = 0, high = 0;      // SI
  int steps = 0;                 // of a grid
  bool log = false;

  // `share` in [0, 1).
  std::string at(double share) const {
    if (!list.empty()) return list[std::size_t(share * double(list.size()))];
    return all_digits(log ? low * std::pow(high / low, share) : low + share * (high - low));
  }
  std::string step(int k) const { // ends of a range are as they were written
    if (!list.empty()) return list[std::size_t(k)];
    return k + 1 == steps ? all_digits(high) : at(double(k) / (steps - 1));
  }
};

class Planner {
public:
  Planner(const CaseFile& file, const SweepRequest& request)
      : request_(request), changed_(file), data_(file.data) {}

  SweepPlan plan() {
    if (request_.table.empty() == request_.vary.empty())
      refuse(request_.vary.empty() ? "--vary" : "--table",
             request_.vary.empty() ? "is missing" : "says what --vary says, too",
             "--vary PATH=VALUES, as often as numbers vary, or --table FILE.csv");
    SweepPlan plan = request_.table.empty() ? by_design() : by_table();
    for (SweptColumn& column : plan.columns) add_numbers(column);
    return plan;
  }

private:
  SweepPlan by_table() {
    if (request_.count || request_.design != SweepDesign::grid)
      refuse("--table", "says what varies by itself", "neither --design nor --count");
    const CsvCells cells = read_cells(request_.table);
    SweepPlan plan{.columns = {}, .variants = static_cast<int>(cells.rows.size())};
    for (std::size_t c = 0; c < cells.header.size(); ++c) {
      SweptColumn column{
          .paths = paths_of(cells.header[c]), .unit = {}, .texts = {}, .numbers = {}};
      for (const auto& row : cells.rows) column.texts.push_back(row[c]);
      plan.columns.push_back(std::move(column));
    }
    return plan;
  }

  SweepPlan by_design() {
    std::vector<Varied> varied;
    for (const std::string& words : request_.vary) varied.push_back(read(words));
    const auto sides = static_cast<int>(varied.size());
    SweepPlan plan;
    for (const Varied& v : varied)
      plan.columns.push_back({.paths = v.paths, .unit = {}, .texts = {}, .numbers = {}});
    if (request_.design == SweepDesign::grid) {
      std::vector<int> counts;
      double all = 1;
      for (const Varied& v : varied) {
        counts.push_back(v.list.empty() ? v.steps : static_cast<int>(v.list.size()));
        all *= counts.back();
      }
      limit("--vary", all);
      for (const std::vector<int>& row : combinations(counts))
        for (std::size_t c = 0; c < varied.size(); ++c)
          plan.columns[c].texts.push_back(varied[c].step(row[c]));
    } else {
      const bool latin = request_.design == SweepDesign::latin;
      if (!request_.count) refuse("--count", "is missing", "how many variants, e.g. --count 200");
      limit("--count", *request_.count);
      const Eigen::MatrixXd points = latin ? latin_hypercube(*request_.count, sides, request_.seed)
                                           : sobol_points(*request_.count, sides);
      for (Eigen::Index row = 0; row < points.rows(); ++row)
        for (std::size_t c = 0; c < varied.size(); ++c)
          plan.columns[c].texts.push_back(varied[c].at(points(row, Eigen::Index(c))));
    }
    plan.variants = static_cast<int>(plan.columns.front().texts.size());
    return plan;
  }

  static void limit(const std::string& option, double variants) {
    if (variants > most_variants)
      refuse(option, "makes " + short_number(variants) + " variants", "at most a million");
  }

  std::vector<std::string> paths_of(const std::string& words) {
    constexpr std::array not_of_a_run{"variants", "models", "fit", "diagnose", "measured"};
    std::vector<std::string> paths = parts_of(words, ',');
    for (const std::string& path : paths) {
      for (const char* section : not_of_a_run)
        if (is_below(path, section))
          refuse("--vary", "'" + path + "' changes no run", "a path below parts, caps, ...");
      if (!taken_.insert(path).second)
        refuse("--vary", "'" + path + "' varies twice", "each path once");
    }
    return paths;
  }

  Varied read(const std::string& words) {
    const std::size_t equals = words.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == words.size())
      refuse("--vary", "'" + words + "' has no path or no values",
             "PATH=LOW:HIGH or PATH=A,B,C, e.g. parts.bellows.profile[1].height=7mm:9mm");
    Varied v{.paths = paths_of(words.substr(0, equals)), .list = {}};
    for (const std::string& path : v.paths) changed_.check(path);
    const std::string values = words.substr(equals + 1);
    if (values.find_first_of("[{\"',") == std::string::npos &&
        values.find(':') != std::string::npos)
      range(v, words, parts_of(values, ':'));
    else
      v.list = parts_of(values, ',');
    return v;
  }

  void range(Varied& v, const std::string& words, std::vector<std::string> parts) {
    v.log = parts.back() == "log";
    if (v.log) parts.pop_back();
    const std::optional<Quantity> number = quantity_at(data_, v.paths.front());
    if (!number)
      refuse("--vary", "there is no number at '" + v.paths.front() + "'",
             "a range of a number that this file gives, or a list of values");
    const auto limit = [&](const std::string& text) {
      const ParsedQuantity parsed = parse_quantity(text, number->unit);
      if (!parsed.wrong.empty()) refuse("--vary", words + ": " + parsed.wrong, parsed.allowed);
      return parsed.value;
    };
    const bool grid = request_.design == SweepDesign::grid;
    if (parts.size() != (grid ? 3u : 2u))
      refuse("--vary", "'" + words + "' is no range of " + (grid ? "a grid" : "this design"),
             grid ? "LOW:HIGH:HOW_MANY, or --design latin or sobol with --count"
                  : "LOW:HIGH, with :log where wanted; how many says --count");
    v.low = limit(parts[0]);
    v.high = limit(parts[1]);
    if (!(v.low < v.high)) refuse("--vary", "'" + words + "' ends below its start", "LOW:HIGH");
    if (v.log && !(v.low > 0))
      refuse("--vary", "'" + words + "' reaches zero on a log scale", "a start above zero");
    if (!grid) return;
    const char* end = parts[2].data() + parts[2].size();
    const auto [stop, status] = std::from_chars(parts[2].data(), end, v.steps);
    if (status != std::errc() || stop != end || v.steps < 2)
      refuse("--vary", "'" + parts[2] + "' is no number of steps", "a whole number from 2");
  }

  void add_numbers(SweptColumn& column) {
    const std::optional<Quantity> known = quantity_at(data_, column.paths.front());
    const Dimension dimension = known ? known->unit : Dimension::number;
    for (const std::string& text : column.texts) {
      if (text.empty()) { // as the case says
        column.numbers.push_back(std::numeric_limits<double>::quiet_NaN());
        continue;
      }
      const ParsedQuantity parsed = parse_quantity(text, dimension);
      if (!parsed.wrong.empty()) {
        column.numbers.clear();
        return;
      }
      column.numbers.push_back(parsed.value);
    }
    if (const auto units = units_of(dimension); !units.empty()) column.unit = units.front();
  }

  const SweepRequest& request_;
  ChangedCases changed_;
  Case data_; // quantity_at() asks for one that it could change
  std::set<std::string> taken_;
};

} // namespace

SweepPlan sweep_plan(const CaseFile& file, const SweepRequest& request) {
  return Planner(file, request).plan();
}

Replacements changes_of(const SweepPlan& plan, int variant) {
  Replacements changes;
  for (const SweptColumn& column : plan.columns)
    if (const std::string& text = column.texts[std::size_t(variant)]; !text.empty())
      for (const std::string& path : column.paths) changes[path] = text;
  return changes;
}

} // namespace plica

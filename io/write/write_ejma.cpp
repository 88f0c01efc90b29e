#include "io/write/write_ejma.hpp"

#include "io/files/json_text.hpp"
#include "io/tables/csv.hpp"
#include "io/tables/text.hpp"
#include "io/tables/text_table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plica {
namespace {

// As makers of bellows write them.
ShownUnit sheet_unit(const std::string& unit) {
  if (unit == "m") return {1e3, "mm"};
  if (unit == "m2") return {1e6, "mm2"};
  if (unit == "Pa") return {1e-6, "MPa"};
  if (unit == "N/m") return {1e-3, "N/mm"};
  return {1, unit};
}

std::optional<double> ratio_of(const SheetLine& line) {
  if (!line.formula || !line.shells || *line.formula == 0) return std::nullopt;
  const double ratio = *line.shells / *line.formula;
  return std::isfinite(ratio) ? std::optional(ratio) : std::nullopt;
}

// Of the lines that follow from a life: where that is a bound, so are they, a damage the other way.
std::string bound_of(const SheetLine& line, const std::optional<CurveLife>& life) {
  const bool damage = line.key == "damage";
  if (!life || life->bound == Bound::exact || !(damage || line.key == "N_allowed")) return "";
  return (life->bound == Bound::at_least) != damage ? "at least" : "at most";
}

std::string number_of(const SheetLine& line, const std::optional<double>& value,
                      const std::string& bound) {
  if (!value) return "";
  const std::string number = significant(*value * sheet_unit(line.unit).factor, 4);
  return bound.empty() ? number : bound + " " + number;
}

std::string sheet_text(const EjmaSheet& sheet) {
  std::string text = fmt::format("{}: EJMA formulas beside the shells of the bellows alone, both "
                                 "ends held\n",
                                 sheet.bellows);
  if (!sheet.refused.empty()) text += "the formulas do not apply: " + sheet.refused + "\n";
  TextRows rows{{"", "", "unit", "formula", "shells", "shells/formula"}};
  std::string group;
  for (const SheetLine& line : sheet.lines) {
    if (line.group != group) rows.push_back({line.group});
    group = line.group;
    const auto ratio = ratio_of(line);
    rows.push_back({"  " + line.key, line.text, sheet_unit(line.unit).unit,
                    number_of(line, line.formula, bound_of(line, sheet.life)),
                    number_of(line, line.shells, bound_of(line, sheet.shell_life)),
                    ratio ? fmt::format("{:.3f}", *ratio) : ""});
  }
  text += text_table(rows, "<<<>");
  if (!sheet.curve.empty()) text += "cycles by " + sheet.curve + "\n";
  for (const std::string& remark : sheet.remarks) text += "remark: " + remark + "\n";
  return text;
}

} // namespace

std::string ejma_text(const std::vector<EjmaSheet>& sheets) {
  std::string text;
  for (const EjmaSheet& sheet : sheets) text += (text.empty() ? "" : "\n") + sheet_text(sheet);
  return text;
}

std::string ejma_csv(const std::vector<EjmaSheet>& sheets) {
  std::string text =
      "bellows,group,quantity,meaning,unit,formula,shells,shells/formula,formula bound,shells "
      "bound\n";
  for (const EjmaSheet& sheet : sheets)
    for (const SheetLine& line : sheet.lines)
      text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", csv_cell(sheet.bellows),
                          csv_cell(line.group), csv_cell(line.key), csv_cell(line.text),
                          csv_cell(line.unit), csv_number(line.formula), csv_number(line.shells),
                          csv_number(ratio_of(line)), bound_of(line, sheet.life),
                          bound_of(line, sheet.shell_life));
  return text;
}

std::string ejma_json(const std::vector<EjmaSheet>& sheets, const std::string& case_name) {
  Json bellows = Json::array();
  for (const EjmaSheet& sheet : sheets) {
    Json lines = Json::array();
    for (const SheetLine& line : sheet.lines)
      lines.push_back({{"group", line.group},
                       {"quantity", line.key},
                       {"meaning", line.text},
                       {"unit", line.unit},
                       {"formula", json_number(line.formula)},
                       {"shells", json_number(line.shells)},
                       {"ratio", json_number(ratio_of(line))},
                       {"formula_bound", bound_of(line, sheet.life)},
                       {"shells_bound", bound_of(line, sheet.shell_life)}});
    bellows.push_back({{"name", sheet.bellows},
                       {"refused", sheet.refused},
                       {"curve", sheet.curve},
                       {"remarks", sheet.remarks},
                       {"lines", lines}});
  }
  return json_text({{"case", case_name}, {"bellows", bellows}});
}

std::vector<std::string> ejma_files() {
  return {"ejma.txt", "ejma.csv", "ejma.json"};
}

void write_ejma(const std::vector<EjmaSheet>& sheets, const std::string& case_name,
                OutputFolder& out) {
  out.add("ejma.txt", ejma_text(sheets));
  out.add("ejma.csv", ejma_csv(sheets));
  out.add("ejma.json", ejma_json(sheets, case_name));
}

} // namespace plica
